// The forms of an octree are counted without making them: against OctoMap making them.
#include "evaluation/map_under_test.hpp"
#include "evaluation/sequence.hpp"
#include "support/octomap_twin.hpp"

#include <gtest/gtest.h>

namespace rmap::evaluation {
namespace {

OctreeNodes nodes_of(const octomap::OcTree& tree) {
  const std::uint64_t leaves = tree.getNumLeafNodes();
  return {.inner = tree.calcNumNodes() - leaves, .leaf = leaves};
}

TEST(OctreeForms, AreThoseThatOctoMapMakes) {
  const Sequence sequence = campus_sequence(2);
  const auto map = make_octomap(0.4);
  ASSERT_NE(map, nullptr);
  octomap::OcTree tree(0.4);
  for (const Scan& scan : sequence.scans) {
    map->insert(scan);
    test::insert_into(tree, scan);
  }
  const OctomapMap::Forms forms = map->forms();
  const OctreeNodes pruned = nodes_of(tree);
  EXPECT_EQ(forms.pruned.inner, pruned.inner);
  EXPECT_EQ(forms.pruned.leaf, pruned.leaf);

  octomap::OcTree likely(tree);
  likely.toMaxLikelihood();
  likely.prune();
  EXPECT_EQ(forms.maximum_likelihood.inner, nodes_of(likely).inner);
  EXPECT_EQ(forms.maximum_likelihood.leaf, nodes_of(likely).leaf);

  const std::set<Cell, test::MortonOrder> occupied = test::occupied_cells(tree);  // expands it
  EXPECT_EQ(forms.uncompressed.inner, nodes_of(tree).inner);
  EXPECT_EQ(forms.uncompressed.leaf, nodes_of(tree).leaf);
  EXPECT_GT(forms.uncompressed.leaf, forms.pruned.leaf);
  EXPECT_LT(forms.maximum_likelihood.leaf, forms.pruned.leaf);
  EXPECT_EQ(map->occupied_cells(), std::vector<Cell>(occupied.begin(), occupied.end()));
  EXPECT_EQ(map->extract(), occupied.size());
}

}  // namespace
}  // namespace rmap::evaluation
