// What the experiments make of OctoMap's maps, against OctoMap itself.
#include "evaluation/map_under_test.hpp"
#include "evaluation/sequence.hpp"
#include "support/octomap_twin.hpp"

#include <algorithm>
#include <iterator>

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

std::optional<double> probability_in(const octomap::OcTree& tree, const octomap::OcTreeKey& key) {
  const octomap::OcTreeNode* node = tree.search(key);
  return node == nullptr ? std::nullopt : std::optional(node->getOccupancy());
}

TEST(OctomapOfOrigins, IsThatOfOneOriginWhereAllAreTheSame) {
  Sequence sequence = campus_sequence(2);
  const auto map = make_octomap(0.4);
  octomap::OcTree tree(0.4);
  for (Scan& scan : sequence.scans) {
    test::insert_into(tree, scan);
    scan.origins.assign(scan.points.size(), scan.map_from_sensor.translation());
    scan.map_from_sensor = Pose::Identity();
    map->insert(scan);
  }
  tree.expand();
  int cells = 0;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    ASSERT_EQ(map->probability(test::cell_of(leaf.getKey())), probability_in(tree, leaf.getKey()));
    ++cells;
  }
  EXPECT_GT(cells, 10000);
}

// A lidar that moved during its scans: both systems take each beam from where it started.
TEST(OctomapOfOrigins, HasTheOccupiedCellsOfOurs) {
  Sequence sequence = campus_sequence(3);
  const auto theirs = make_octomap(0.4);
  RmapMap ours({.resolution = 0.4}, History::complete);
  RmapMap of_poses({.resolution = 0.4}, History::complete);
  for (const Scan& scan : sequence.scans) of_poses.prepare(scan);
  for (const Scan& scan : sequence.scans) of_poses.insert(scan);
  for (Scan& scan : sequence.scans) {
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const double moved = static_cast<double>(i / 1000);  // in steps, as a lidar's packets do
      scan.origins.emplace_back(Vector3d(scan.map_from_sensor.translation()) +
                                Vector3d(0.03125 * moved, 0.015625 * moved, 0));
    }
  }
  for (const Scan& scan : sequence.scans) ours.prepare(scan);
  for (const Scan& scan : sequence.scans) {
    ours.insert(scan);
    theirs->insert(scan);
  }
  const std::vector<Cell> one = ours.occupied_cells();
  const std::vector<Cell> other = theirs->occupied_cells();
  std::vector<Cell> different;
  std::set_symmetric_difference(one.begin(), one.end(), other.begin(), other.end(),
                                std::back_inserter(different), morton_less);
  EXPECT_LE(1000 * different.size(), one.size());  // OctoMap's walk is rounded on its way
  EXPECT_GT(one.size(), 1000u);
  EXPECT_FALSE(same_map(ours.grid(), of_poses.grid()));
}

}  // namespace
}  // namespace rmap::evaluation
