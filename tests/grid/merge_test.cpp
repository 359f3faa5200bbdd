#include "support/scans.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/grid.hpp>

namespace rmap {
namespace {

using test::Random;

Grid random_grid(Random& random, const Options& options, int scans) {
  Grid grid(options);
  for (int i = 0; i < scans; ++i) grid.insert(test::random_scan(random, 300, 5));
  return grid;
}

TEST(Merge, AddsLogOddsAndKeepsWhatOnlyOneKnows) {
  Random random(21);
  SCOPED_TRACE(random.trace());
  int shared = 0;
  int single = 0;
  for (const Layout ours : {Layout::blocks, Layout::cells}) {
    for (const Layout theirs : {Layout::blocks, Layout::cells}) {
      const Grid a = random_grid(random, {.resolution = 0.5, .layout = ours, .prior = 0.45}, 4);
      const Grid b = random_grid(
          random, {.resolution = 0.5, .layout = theirs, .clamp_max = 0.99, .prior = 0.45}, 4);
      Grid merged = a;
      merged.merge(b);
      EXPECT_EQ(merged.check().value_or(""), "");
      std::size_t cells = a.cell_count();
      b.visit_leaves(all_cells(), [&](const Leaf& leaf) {
        leaf.for_each([&](const Cell& cell, Value value) {
          const auto before = a.cell_value(cell);
          cells += before ? 0 : 1;
          const Value expected =
              before ? a.rule().clamped(*before + value - a.rule().prior()) : value;
          EXPECT_EQ(merged.cell_value(cell), expected);
          (before ? shared : single) += 1;
        });
        return true;
      });
      a.visit_leaves(all_cells(), [&](const Leaf& leaf) {
        leaf.for_each([&](const Cell& cell, Value value) {
          if (!b.cell_value(cell)) {
            EXPECT_EQ(merged.cell_value(cell), value);
          }
        });
        return true;
      });
      EXPECT_EQ(merged.cell_count(), cells);
      EXPECT_EQ(merged.scan_poses().size(), 8u);
      EXPECT_EQ(merged.history(), History::first_hit);
      EXPECT_EQ(merged.revision(), a.revision() + 1);
    }
  }
  EXPECT_GT(shared, 100);
  EXPECT_GT(single, 100);
}

TEST(Merge, WithAnEmptyMapChangesNothing) {
  Random random(22);
  SCOPED_TRACE(random.trace());
  const Options options{.resolution = 0.5};
  const Grid grid = random_grid(random, options, 3);
  Grid merged = grid;
  merged.merge(Grid(options));
  EXPECT_TRUE(same_map(merged, grid));
  Grid blank(options);
  blank.merge(grid);
  EXPECT_TRUE(same_map(blank, grid));
}

TEST(Merge, WithItselfDoublesTheEvidence) {
  Grid grid({.resolution = 1});
  grid.set_value({0, 0, 0}, 600);
  grid.set_value({1, 0, 0}, 3000);
  grid.merge(grid);
  EXPECT_EQ(grid.cell_value({0, 0, 0}), 1200);
  EXPECT_EQ(grid.cell_value({1, 0, 0}), value_of(0.971));
}

TEST(Merge, IsCompleteOnlyWithoutScansAndOfCompleteMaps) {
  for (const History a : {History::complete, History::first_hit}) {
    for (const History b : {History::complete, History::first_hit}) {
      Grid grid({.resolution = 1});
      Grid other({.resolution = 1});
      grid.set({0, 0, 0}, 0.9);
      other.set({1, 0, 0}, 0.9);
      grid.restore(a, {});
      other.restore(b, {});
      grid.merge(other);
      EXPECT_EQ(grid.history(), a == History::complete && b == History::complete
                                    ? History::complete
                                    : History::first_hit);
    }
  }
}

TEST(Merge, RefusesMapsOfAnotherMeaning) {
  Grid grid({.resolution = 0.1});
  const auto refusal = [&](const Options& options) -> std::string {
    try {
      grid.merge(Grid(options));
    } catch (const Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal({.resolution = 0.2}), testing::HasSubstr("resolution is 0.1 in one and 0.2"));
  EXPECT_THAT(refusal({.resolution = 0.1, .prior = 0.45}), testing::HasSubstr("prior is 0.5"));
  EXPECT_EQ(refusal({.resolution = 0.1, .prob_hit = 0.9}), "accepted");
}

}  // namespace
}  // namespace rmap
