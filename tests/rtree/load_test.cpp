#include "rtree/boxes.hpp"
#include "rtree/oracle.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include <rmap/rtree.hpp>

namespace rmap {
namespace {

using test::Data;
using test::Found;
using test::Items;
using test::Random;
using test::Tree;

Items items_of(const std::vector<CellBox>& boxes) {
  Items items;
  for (const CellBox& box : boxes) items.push_back({box, static_cast<int>(items.size())});
  return items;
}

Found content(const Tree& tree) {
  Found found;
  tree.for_each(test::into(found));
  return found;
}

Found content(const Items& items) {
  return test::plain_search(items, [](const CellBox&) { return true; });
}

TEST(Load, PacksAnyNumberOfItems) {
  int compared = 0;
  for (const RTreeOptions& options : test::all_options()) {
    if (options.split == Split::linear) continue;
    Random random(3);
    SCOPED_TRACE(random.trace() + ", " + test::text_of(options));
    const Items items = items_of(test::boxes_of(Data::random, options.leaf_edge, 400, random));
    const auto max = static_cast<std::size_t>(options.max_branches);
    for (const std::size_t count :
         {std::size_t{0}, std::size_t{1}, max - 1, max, max + 1, max + max / 2, 2 * max + 1,
          std::size_t{300}, std::size_t{400}}) {
      for (const Packing packing : {Packing::sort_tile_recursive, Packing::hilbert}) {
        const Items some(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(count));
        const Tree tree = Tree::bulk_load(some, options, packing);
        ASSERT_EQ(tree.check(), std::nullopt);
        ASSERT_EQ(tree.size(), count);
        ASSERT_EQ(content(tree), content(some));
        const RTreeStatistics statistics = tree.statistics();
        std::size_t below = count;
        for (const RTreeLevelStatistics& level : statistics.levels) {
          ASSERT_EQ(level.branches, below);
          below = (below + max - 1) / max;  // nodes as full as can be
          ASSERT_EQ(level.nodes, below);
        }
        ASSERT_EQ(count == 0, statistics.levels.empty());
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 36 * 9 * 2);
}

TEST(Load, PackedTreesTakeFurtherChanges) {
  int changes = 0;
  for (const RTreeOptions& options : test::all_options()) {
    for (const Data data : test::kAllData) {
      Random random(static_cast<std::uint64_t>(data));
      SCOPED_TRACE(random.trace() + ", " + test::text_of(options));
      Items items = items_of(test::boxes_of(data, options.leaf_edge, 90, random));
      const Items later(items.begin() + 60, items.end());
      items.resize(60);
      const Packing packing = random.chance(0.5) ? Packing::sort_tile_recursive : Packing::hilbert;
      Tree tree = Tree::bulk_load(items, options, packing);
      for (const Tree::Item& item : later) {
        tree.insert(item.box, item.payload);
        items.push_back(item);
        const auto victim = items.begin() + random.integer(0, static_cast<int>(items.size()) - 1);
        const int payload = victim->payload;
        ASSERT_TRUE(tree.erase_if(victim->box, [&](int other) { return other == payload; }));
        items.erase(victim);
        ASSERT_EQ(tree.check(), std::nullopt);
        ++changes;
      }
      ASSERT_EQ(content(tree), content(items));
      tree.repack(packing);
      ASSERT_EQ(tree.check(), std::nullopt);
      ASSERT_EQ(content(tree), content(items));
    }
  }
  EXPECT_EQ(changes, 72 * 9 * 30);
}

TEST(Load, RepackGivesBackMemoryAndFillsNodes) {
  RTree<int> tree({.leaf_edge = 1});
  for (int i = 0; i < 20000; ++i) tree.insert(box_of({i % 100, i / 100, 0}), i);
  for (int i = 0; i < 15000; ++i) ASSERT_TRUE(tree.erase(box_of({i % 100, i / 100, 0})));
  const auto before = tree.bytes_in_use();
  tree.repack();
  EXPECT_EQ(tree.check(), std::nullopt);
  EXPECT_LT(tree.bytes_in_use(), before / 3);
  EXPECT_EQ(tree.statistics().levels.front().nodes, (5000u + 15) / 16);
  tree.clear();
  EXPECT_EQ(tree.bytes_in_use(), 0u);
  tree.repack();
  EXPECT_TRUE(tree.empty());
}

TEST(Load, SaysWhichItemItRefuses) {
  const Items items = {{box_of({0, 0, 0}), 1}, {CellBox{}, 2}};
  try {
    Tree::bulk_load(items);
    FAIL() << "accepted an empty box";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_STREQ(error.what(),
                 "the box of item 1 from (0, 0, 0) to (0, 0, 0) is empty: an R-tree holds boxes "
                 "with a volume");
  }
}

}  // namespace
}  // namespace rmap
