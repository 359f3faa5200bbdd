#include "rtree/boxes.hpp"

#include <gtest/gtest.h>

#include <rmap/rtree.hpp>
#include <rmap/rtree/statistics.hpp>

namespace rmap {
namespace {

using test::Random;

TEST(Statistics, OfTheEmptyTree) {
  const RTreeStatistics statistics = RTree<int>().statistics();
  EXPECT_TRUE(statistics.levels.empty());
  EXPECT_EQ(statistics.height, 0);
  EXPECT_EQ(statistics.items, 0u);
  EXPECT_EQ(statistics.nodes, 0u);
  EXPECT_EQ(statistics.bytes_in_use, 0u);
}

TEST(Statistics, OfOneLeafByHand) {
  RTree<int> tree({.max_branches = 4});
  tree.insert({.min = {0, 0, 0}, .max = {4, 2, 2}}, 1);  // 16 cells
  tree.insert({.min = {3, 1, 0}, .max = {6, 3, 2}}, 2);  // 12 cells, shares 1 x 1 x 2 with it
  tree.insert({.min = {3, 1, 1}, .max = {4, 2, 3}}, 3);  // 2 cells, one of them in both others
  const RTreeStatistics statistics = tree.statistics();
  ASSERT_EQ(statistics.levels.size(), 1u);
  const RTreeLevelStatistics& leaves = statistics.levels[0];
  EXPECT_EQ(leaves.level, 0);
  EXPECT_EQ(leaves.nodes, 1u);
  EXPECT_EQ(leaves.branches, 3u);
  EXPECT_EQ(leaves.fill, 0.75);
  EXPECT_EQ(leaves.volume, 6 * 3 * 3);
  EXPECT_EQ(leaves.overlap_volume, 2 + 1 + 1);
  EXPECT_EQ(leaves.dead_space, 54 - (16 + 12 - 2 + 1));
}

TEST(Statistics, OfTwoLevelsByHand) {
  // Along x, runs of 4: MBRCs of 4 and of 5 cells, with a gap of 2 between and one within.
  std::vector<RTree<int>::Item> items;
  for (const int x : {0, 1, 2, 3, 6, 7, 8, 10}) items.push_back({box_of({x, 0, 0}), x});
  const auto tree = RTree<int>::bulk_load(items, {.max_branches = 4});
  const RTreeStatistics statistics = tree.statistics();
  EXPECT_EQ(statistics.height, 2);
  EXPECT_EQ(statistics.items, 8u);
  EXPECT_EQ(statistics.nodes, 3u);
  EXPECT_EQ(statistics.bytes_in_use, tree.bytes_in_use());
  ASSERT_EQ(statistics.levels.size(), 2u);
  const RTreeLevelStatistics& leaves = statistics.levels[0];
  EXPECT_EQ(leaves.nodes, 2u);
  EXPECT_EQ(leaves.branches, 8u);
  EXPECT_EQ(leaves.fill, 1);
  EXPECT_EQ(leaves.volume, 4 + 5);
  EXPECT_EQ(leaves.overlap_volume, 0);
  EXPECT_EQ(leaves.dead_space, 1);
  const RTreeLevelStatistics& root = statistics.levels[1];
  EXPECT_EQ(root.level, 1);
  EXPECT_EQ(root.nodes, 1u);
  EXPECT_EQ(root.branches, 2u);
  EXPECT_EQ(root.fill, 0.5);
  EXPECT_EQ(root.volume, 11);
  EXPECT_EQ(root.overlap_volume, 0);
  EXPECT_EQ(root.dead_space, 2);
}

TEST(Statistics, LevelsFitTogether) {
  Random random(2);
  SCOPED_TRACE(random.trace());
  for (const RTreeOptions& options : test::all_options()) {
    RTree<int> tree(options);
    for (const CellBox& box : test::boxes_of(test::Data::random, options.leaf_edge, 300, random)) {
      tree.insert(box, 0);
    }
    const RTreeStatistics statistics = tree.statistics();
    ASSERT_EQ(statistics.height, tree.height());
    ASSERT_EQ(statistics.levels.front().branches, tree.size());
    ASSERT_EQ(statistics.levels.back().nodes, 1u);
    for (std::size_t i = 1; i < statistics.levels.size(); ++i) {
      ASSERT_EQ(statistics.levels[i].branches, statistics.levels[i - 1].nodes);
      ASSERT_LE(statistics.levels[i].dead_space, statistics.levels[i].volume);
    }
    ASSERT_EQ(statistics.levels.back().volume, tree.bounds().volume());
  }
}

}  // namespace
}  // namespace rmap
