#include "rtree/boxes.hpp"
#include "rtree/oracle.hpp"
#include "rtree/plain_tree.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include <rmap/rtree.hpp>

namespace rmap {
namespace {

using test::Data;
using test::Random;

constexpr std::size_t kInserted = 120;

constexpr auto kAny = [](BoxTree::Place) { return true; };

TEST(Erase, LeavesTheVeryTreeOfThePlainAlgorithmDownToTheEmptyOne) {
  int compared = 0;
  for (const RTreeOptions& options : test::all_options()) {
    for (const Data data : test::kAllData) {
      Random random(static_cast<std::uint64_t>(data));
      SCOPED_TRACE(random.trace() + ", " + test::text_of(options));
      BoxTree tree(options, sizeof(int), alignof(int));
      test::PlainTree plain(tree.options());
      auto boxes = test::boxes_of(data, options.leaf_edge, kInserted, random);
      for (int i = 0; i < static_cast<int>(kInserted); ++i) {
        tree.insert(boxes[static_cast<std::size_t>(i)], reinterpret_cast<const std::byte*>(&i));
        plain.insert(boxes[static_cast<std::size_t>(i)], i);
      }
      std::shuffle(boxes.begin(), boxes.end(), random.engine());
      for (std::size_t left = kInserted; left-- > 0;) {
        ASSERT_TRUE(tree.erase(boxes[left], kAny));
        ASSERT_TRUE(plain.erase(boxes[left]));
        ASSERT_EQ(tree.check(), std::nullopt);
        ASSERT_EQ(tree.size(), left);
        if (left % 10 == 0) {
          ASSERT_TRUE(plain.same_as(tree)) << left;
        }
      }
      ASSERT_EQ(tree.height(), 0);
      ASSERT_EQ(tree.nodes(0).size() + tree.nodes(1).size(), 0u);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 72 * 9);
}

TEST(Erase, WantsExactlyTheBox) {
  RTree<int> tree;
  EXPECT_FALSE(tree.erase(box_of({0, 0, 0})));
  tree.insert({.min = {0, 0, 0}, .max = {4, 4, 4}}, 1);
  EXPECT_FALSE(tree.erase({.min = {0, 0, 0}, .max = {4, 4, 5}}));
  EXPECT_FALSE(tree.erase({.min = {0, 0, 0}, .max = {4, 4, 3}}));
  EXPECT_FALSE(tree.erase(CellBox{}));
  EXPECT_TRUE(tree.erase({.min = {0, 0, 0}, .max = {4, 4, 4}}));
  EXPECT_TRUE(tree.empty());

  RTree<int> cubes({.leaf_edge = 4});
  cubes.insert({.min = {0, 0, 0}, .max = {4, 4, 4}}, 1);
  EXPECT_FALSE(cubes.erase(box_of({0, 0, 0})));
  EXPECT_TRUE(cubes.erase({.min = {0, 0, 0}, .max = {4, 4, 4}}));
}

TEST(Erase, ErasesOneOfManyIdenticalOnes) {
  RTree<int> tree({.max_branches = 4});
  const CellBox box{.min = {-1, -1, -1}, .max = {2, 2, 2}};
  for (int i = 0; i < 100; ++i) tree.insert(box, i);
  for (std::size_t left = 100; left-- > 0;) {
    ASSERT_TRUE(tree.erase(box));
    ASSERT_EQ(tree.size(), left);
    ASSERT_EQ(tree.check(), std::nullopt);
  }
  EXPECT_FALSE(tree.erase(box));
}

TEST(Erase, EraseIfErasesTheOneWhosePayloadMatches) {
  RTree<int> tree({.max_branches = 4});
  const CellBox box{.min = {-1, -1, -1}, .max = {2, 2, 2}};
  for (int i = 0; i < 100; ++i) tree.insert(box, i);
  EXPECT_FALSE(tree.erase_if(box, [](const int& payload) { return payload == 100; }));
  for (int i = 99; i >= 0; i -= 2) {
    ASSERT_TRUE(tree.erase_if(box, [&](const int& payload) { return payload == i; }));
    ASSERT_FALSE(tree.erase_if(box, [&](const int& payload) { return payload == i; }));
    ASSERT_EQ(tree.check(), std::nullopt);
  }
  int sum = 0;
  tree.for_each([&](const CellBox&, int payload) { sum += payload; });
  EXPECT_EQ(sum, 49 * 50);
}

}  // namespace
}  // namespace rmap
