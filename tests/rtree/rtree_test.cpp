#include "rtree/boxes.hpp"
#include "rtree/oracle.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

#include <gtest/gtest.h>

#include <rmap/rtree.hpp>

namespace rmap {
namespace {

using test::Random;
using test::Tree;

Tree tree_of(int items) {
  Tree tree({.max_branches = 4});
  for (int i = 0; i < items; ++i) tree.insert(box_of({i * 7 % 100, i % 10, i}), i);
  return tree;
}

/// All items in the order of the tree.
std::vector<std::pair<CellBox, int>> listed(const Tree& tree) {
  std::vector<std::pair<CellBox, int>> items;
  tree.for_each([&](const CellBox& box, int payload) { items.emplace_back(box, payload); });
  return items;
}

TEST(RTree, TheEmptyTree) {
  const Tree tree;
  EXPECT_TRUE(tree.empty());
  EXPECT_EQ(tree.size(), 0u);
  EXPECT_EQ(tree.height(), 0);
  EXPECT_TRUE(tree.bounds().empty());
  EXPECT_EQ(tree.bytes_in_use(), 0u);
  EXPECT_EQ(tree.find(box_of({0, 0, 0})), nullptr);
  EXPECT_EQ(tree.check(), std::nullopt);
  EXPECT_EQ(tree.options().max_branches, 16);
  EXPECT_EQ(tree.options().min_branches, 8);
}

TEST(RTree, GrowsByALevelWhenTheRootSplits) {
  Tree tree({.max_branches = 4});
  for (int i = 0; i < 4; ++i) tree.insert(box_of({i, 0, 0}), i);
  EXPECT_EQ(tree.height(), 1);
  tree.insert(box_of({4, 0, 0}), 4);
  EXPECT_EQ(tree.height(), 2);
  EXPECT_EQ(tree.bounds(), (CellBox{.min = {0, 0, 0}, .max = {5, 1, 1}}));
  EXPECT_EQ(tree.size(), 5u);
}

TEST(RTree, ACopyIsIndependent) {
  Tree tree = tree_of(300);
  const auto before = listed(tree);
  Tree copy = tree;
  EXPECT_EQ(listed(copy), before);
  for (int i = 0; i < 150; ++i) ASSERT_TRUE(copy.erase(before[static_cast<std::size_t>(i)].first));
  copy.for_each([](const CellBox&, int& payload) { payload = -1; });
  EXPECT_EQ(listed(tree), before);
  EXPECT_EQ(tree.check(), std::nullopt);
  EXPECT_EQ(copy.check(), std::nullopt);
  EXPECT_EQ(copy.size(), 150u);

  const auto of_copy = listed(copy);
  tree.clear();
  EXPECT_EQ(listed(copy), of_copy);
  tree = copy;
  copy.clear();
  EXPECT_EQ(listed(tree), of_copy);
}

TEST(RTree, AMoveLeavesAnEmptyTreeThatWorks) {
  static_assert(std::is_nothrow_move_constructible_v<Tree>);
  static_assert(std::is_nothrow_move_assignable_v<Tree>);
  Tree tree = tree_of(100);
  const auto before = listed(tree);
  Tree moved = std::move(tree);
  EXPECT_EQ(listed(moved), before);
  EXPECT_TRUE(tree.empty());              // NOLINT(bugprone-use-after-move): documented to be empty
  EXPECT_EQ(tree.check(), std::nullopt);  // NOLINT(clang-analyzer-cplusplus.Move): and sound
  tree.insert(box_of({1, 2, 3}), 4);
  EXPECT_EQ(tree.check(), std::nullopt);
  tree = std::move(moved);
  EXPECT_EQ(listed(tree), before);
  Tree& same = tree;
  tree = same;
  EXPECT_EQ(listed(tree), before);
}

TEST(RTree, TheSameCallsGiveTheSameTree) {
  const auto calls = [] {
    Random random(8);
    Tree tree({.max_branches = 5, .split = Split::linear});
    std::vector<CellBox> boxes;
    for (int i = 0; i < 500; ++i) {
      boxes.push_back(random.box(-30, 30, 9));
      tree.insert(boxes.back(), i);
      if (i % 3 == 2) {
        tree.erase(boxes[static_cast<std::size_t>(random.integer(0, i))]);
      }
    }
    return tree;
  };
  EXPECT_EQ(listed(calls()), listed(calls()));
}

TEST(RTree, APayloadMayComeFromTheTreeItself) {
  Tree tree({.max_branches = 4});
  tree.insert(box_of({0, 0, 0}), 1234567);
  for (int i = 1; i < 200; ++i) {
    tree.insert(box_of({i * 37 % 200, 0, 0}), *tree.find(box_of({0, 0, 0})));
  }
  tree.for_each([](const CellBox&, int payload) { EXPECT_EQ(payload, 1234567); });
}

template <class Payload>
class RTreePayload : public testing::Test {};

struct Empty {};
struct Odd {
  std::uint8_t bytes[11];
};
struct Wide {
  double numbers[5];
  std::uint8_t last;
};
using Payloads = testing::Types<Empty, std::uint8_t, std::int16_t, Odd, double, Wide, void*>;
TYPED_TEST_SUITE(RTreePayload, Payloads);

template <class Payload>
Payload payload_of(int number) {
  Payload payload{};
  // Payloads are bytes to the tree; each gets a pattern of its own.
  if constexpr (!std::is_empty_v<Payload>) {
    std::memset(static_cast<void*>(&payload), number % 251, sizeof(payload));
  }
  return payload;
}

TYPED_TEST(RTreePayload, AnyThatCanBeCopiedAsBytesStaysWithItsBox) {
  for (const int leaf_edge : {0, 1}) {
    RTree<TypeParam> tree({.max_branches = 5, .leaf_edge = leaf_edge});
    constexpr int kItems = 400;
    for (int i = 0; i < kItems; ++i) {
      tree.insert(box_of({i * 7 % kItems, 0, 0}), payload_of<TypeParam>(i * 7 % kItems));
    }
    for (int i = 0; i < kItems; i += 2) ASSERT_TRUE(tree.erase(box_of({i, 0, 0})));
    int visits = 0;
    tree.for_each([&](const CellBox& box, const TypeParam& payload) {
      const auto address = reinterpret_cast<std::uintptr_t>(&payload);
      ASSERT_EQ(address % alignof(TypeParam), 0u);
      const TypeParam expected = payload_of<TypeParam>(box.min.x());
      if constexpr (!std::is_empty_v<TypeParam>) {
        const auto bytes = std::as_bytes(std::span(&payload, 1));
        ASSERT_TRUE(std::ranges::equal(bytes, std::as_bytes(std::span(&expected, 1))));
      }
      ++visits;
    });
    EXPECT_EQ(visits, kItems / 2);
    EXPECT_EQ(tree.check(), std::nullopt);
  }
}

}  // namespace
}  // namespace rmap
