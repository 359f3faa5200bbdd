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
using test::plain_search;
using test::Random;
using test::Tree;

constexpr int kStages = 4;
constexpr int kRegions = 10;

/// Compares every search with the plain one; returns how many.
int compare_searches(const Tree& tree, const Items& items, Random& random) {
  int compared = 0;
  const auto expect_same = [&](const Found& found, const Found& expected) {
    EXPECT_EQ(found, expected);
    ++compared;
  };
  const CellBox bounds = tree.bounds();
  for (int i = 0; i < kRegions; ++i) {
    const CellBox region =
        i == 0 && !items.empty() ? items[0].box : test::region_of(bounds, random);
    Found overlapping;
    EXPECT_TRUE(tree.overlapping(region, test::into(overlapping)));
    expect_same(overlapping,
                plain_search(items, [&](const CellBox& box) { return box.overlaps(region); }));

    Found contained;
    EXPECT_TRUE(tree.contained_in(region, test::into(contained)));
    expect_same(contained,
                plain_search(items, [&](const CellBox& box) { return region.contains(box); }));

    Found descended;
    const auto enter = [&](const CellBox& box) { return box.overlaps(region); };
    EXPECT_TRUE(tree.descend(enter, test::into(descended)));
    expect_same(descended, overlapping);
    const auto least = static_cast<std::size_t>(random.integer(1, 60));
    Found in_parts;
    for (const Tree::Subtree& part : tree.subtrees(least, enter)) {
      EXPECT_TRUE(tree.descend(part, enter, test::into(in_parts)));
    }
    expect_same(in_parts, overlapping);

    const Cell cell = test::cell_of(bounds, random);
    Found containing;
    EXPECT_TRUE(tree.containing(cell, test::into(containing)));
    expect_same(containing,
                plain_search(items, [&](const CellBox& box) { return box.contains(cell); }));

    const Beam beam = test::beam_of(i % test::kBeamKinds, bounds, random);
    Found crossed;
    EXPECT_TRUE(tree.crossed_by(beam, test::into(crossed)));
    expect_same(crossed, plain_search(items, [&](const CellBox& box) {
                  return crossing(beam, box).has_value();
                }));
  }
  for (std::size_t i = 0; i < 5 && i < items.size(); ++i) {
    const CellBox& box = items[i].box;
    const int* payload = tree.find(box);
    EXPECT_NE(payload, nullptr);
    if (payload == nullptr) continue;
    EXPECT_TRUE(std::any_of(items.begin(), items.end(), [&](const Tree::Item& item) {
      return item.box == box && item.payload == *payload;
    }));
    const CellBox other{.min = box.min, .max = box.max + Cell(0, 0, 1)};
    const bool known = std::any_of(items.begin(), items.end(),
                                   [&](const Tree::Item& item) { return item.box == other; });
    EXPECT_EQ(tree.find(other) != nullptr, known);
  }
  return compared;
}

TEST(Search, EqualsThePlainSearchThroughAllChanges) {
  int compared = 0;
  for (const RTreeOptions& options : test::all_options()) {
    for (const Data data : test::kAllData) {
      Random random(static_cast<std::uint64_t>(data));
      SCOPED_TRACE(random.trace() + ", " + test::text_of(options));
      Tree tree(options);
      Items items;
      compared += compare_searches(tree, items, random);  // the empty tree
      for (const CellBox& box : test::boxes_of(data, options.leaf_edge, 150, random)) {
        items.push_back({box, static_cast<int>(items.size())});
        tree.insert(box, items.back().payload);
      }
      compared += compare_searches(tree, items, random);

      for (int i = 0; i < 75; ++i) {
        const auto victim = items.begin() + random.integer(0, static_cast<int>(items.size()) - 1);
        const int payload = victim->payload;
        ASSERT_TRUE(tree.erase_if(victim->box, [&](int other) { return other == payload; }));
        items.erase(victim);
      }
      // Payloads change in place.
      for (Tree::Item& item : items) item.payload += 1000;
      tree.for_each([](const CellBox&, int& payload) { payload += 1000; });
      compared += compare_searches(tree, items, random);

      tree.repack(random.chance(0.5) ? Packing::sort_tile_recursive : Packing::hilbert);
      compared += compare_searches(tree, items, random);
      ASSERT_EQ(tree.check(), std::nullopt);
      if (HasFailure()) return;
    }
  }
  EXPECT_EQ(compared, 72 * 9 * kStages * kRegions * 6);
}

TEST(Search, AVisitorThatReturnsFalseStopsIt) {
  Tree tree({.max_branches = 4});
  for (int i = 0; i < 50; ++i) tree.insert(box_of({i, 0, 0}), i);
  const Tree& reader = tree;
  const CellBox everything = tree.bounds();
  const Beam beam({-1, 0.5, 0.5}, {60, 0.5, 0.5}, false);
  const auto all = [](const CellBox&) { return true; };
  int visits = 0;
  const auto third = [&](const CellBox&, int) { return ++visits < 3; };
  const auto expect_stopped = [&](bool finished) {
    EXPECT_FALSE(finished);
    EXPECT_EQ(visits, 3);
    visits = 0;
  };
  expect_stopped(tree.for_each(third));
  expect_stopped(tree.overlapping(everything, third));
  expect_stopped(tree.contained_in(everything, third));
  expect_stopped(tree.crossed_by(beam, third));
  expect_stopped(tree.descend(all, third));
  expect_stopped(reader.for_each(third));
  expect_stopped(reader.overlapping(everything, third));
  expect_stopped(reader.contained_in(everything, third));
  expect_stopped(reader.crossed_by(beam, third));
  expect_stopped(reader.descend(all, third));
  EXPECT_FALSE(tree.containing({7, 0, 0}, [](const CellBox&, int) { return false; }));
  EXPECT_TRUE(tree.containing({7, 0, 1}, [](const CellBox&, int) { return false; }));
  EXPECT_TRUE(tree.for_each([](const CellBox&, int) { return true; }));
}

TEST(Search, VisitorsMayChangePayloads) {
  Tree tree({.max_branches = 4});
  for (int i = 0; i < 50; ++i) tree.insert(box_of({i, 0, 0}), 0);
  const CellBox region{.min = {10, 0, 0}, .max = {20, 1, 1}};
  const auto count = [](const CellBox&, int& payload) { ++payload; };
  tree.overlapping(region, count);
  tree.contained_in(region, count);
  tree.containing({10, 0, 0}, count);
  tree.crossed_by(Beam({5, 0.5, 0.5}, {11, 0.5, 0.5}, false), count);
  tree.descend([&](const CellBox& box) { return box.contains(Cell(10, 0, 0)); }, count);
  tree.crossed_in_order(Beam({10, 0.5, 0.5}, {11, 0.5, 0.5}, false),
                        [](const CellBox&, int& payload, double) { return ++payload; });
  EXPECT_EQ(*tree.find(box_of({10, 0, 0})), 6);
  EXPECT_EQ(*tree.find(box_of({11, 0, 0})), 2);
  EXPECT_EQ(*tree.find(box_of({9, 0, 0})), 1);
  EXPECT_EQ(*tree.find(box_of({20, 0, 0})), 0);
  *tree.find(box_of({20, 0, 0})) = 5;
  EXPECT_EQ(*tree.find(box_of({20, 0, 0})), 5);
}

TEST(Search, ToleratesRegionsAndCellsBeyondTheLimits) {
  Tree tree;
  tree.insert(all_cells(), 1);
  constexpr int kLowest = std::numeric_limits<int>::min();
  constexpr int kHighest = std::numeric_limits<int>::max();
  Found found;
  tree.overlapping({.min = Cell::Constant(kLowest), .max = Cell::Constant(kHighest)},
                   test::into(found));
  tree.contained_in({.min = Cell::Constant(kLowest), .max = Cell::Constant(kHighest)},
                    test::into(found));
  EXPECT_EQ(found.size(), 2u);
  tree.containing(Cell::Constant(kHighest), test::into(found));
  tree.containing(Cell::Constant(kLowest), test::into(found));
  tree.overlapping({.min = Cell::Constant(kHighest - 1), .max = Cell::Constant(kHighest)},
                   test::into(found));
  EXPECT_EQ(found.size(), 2u);
}

TEST(Search, DescentAsksAboutABoxRightBeforeWhatLiesBehindIt) {
  Tree tree({.max_branches = 4});
  for (int i = 0; i < 60; ++i) tree.insert(box_of({i * 7 % 60, 0, 0}), i);
  std::vector<CellBox> path;
  int visits = 0;
  tree.descend(
      [&](const CellBox& box) {
        while (!path.empty() && !path.back().contains(box)) path.pop_back();
        path.push_back(box);
        return true;
      },
      [&](const CellBox& box, int) {
        EXPECT_EQ(path.back(), box);
        ++visits;
      });
  EXPECT_EQ(visits, 60);
}

}  // namespace
}  // namespace rmap
