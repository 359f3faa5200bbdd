#include "support/grids.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include <rmap/cells.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::Random;

// Distance from a point to the cube of a cell, by clamping each axis by hand.
bool within(const Grid& grid, const Cell& cell, const Sphere& sphere) {
  double squared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = cell[axis] * grid.options().resolution;
    const double high = (cell[axis] + 1) * grid.options().resolution;
    const double off = std::max({low - sphere.center[axis], 0.0, sphere.center[axis] - high});
    squared += off * off;
  }
  return squared < sphere.radius * sphere.radius;
}

class CellsInLayout : public testing::TestWithParam<Layout> {};
INSTANTIATE_TEST_SUITE_P(Layouts, CellsInLayout, testing::Values(Layout::blocks, Layout::cells));

TEST_P(CellsInLayout, SelectionsEqualAFilterOverAllCells) {
  Random random(34);
  SCOPED_TRACE(random.trace());
  const Grid grid = test::clustered_grid(
      random, {.resolution = 0.25, .layout = GetParam(), .max_branches = 6}, 15);
  const auto all = test::all_cell_values(grid);
  int filled = 0;
  for (int i = 0; i < 300; ++i) {
    CellSelection selection{.occupied_only = random.chance(0.5)};
    const CellBox box = random.box(-20, 10, 20);
    if (random.chance(0.6)) selection.box = grid.lattice().metric(box);
    if (random.chance(0.6)) {
      selection.sphere = Sphere{.center = random.point(-5, 5), .radius = random.real(0, 4)};
    }
    std::vector<CellValue> expected;
    for (const CellValue& entry : all) {
      if ((!selection.box || box.contains(entry.cell)) &&
          (!selection.sphere || within(grid, entry.cell, *selection.sphere)) &&
          (!selection.occupied_only || grid.rule().occupied(entry.value))) {
        expected.push_back(entry);
      }
    }
    std::vector<CellValue> listed;
    for (const CellValue& entry : cells(grid, selection)) listed.push_back(entry);
    ASSERT_EQ(listed, expected);

    std::vector<CellValue> unordered;
    for (const CellValue& entry : cells(grid, selection, Order::any)) unordered.push_back(entry);
    std::vector<CellValue> called;
    for_each_cell(grid, selection, [&](const Cell& cell, Value value) {
      called.push_back({cell, value});
      return true;
    });
    std::vector<CellValue> batched;
    for_each_batch(grid, selection, [&](std::span<const CellValue> batch) {
      EXPECT_FALSE(batch.empty());
      batched.insert(batched.end(), batch.begin(), batch.end());
      return true;
    });
    ASSERT_EQ(batched, called);
    const auto in_order = [](std::vector<CellValue> list) {
      std::sort(list.begin(), list.end(),
                [](const CellValue& a, const CellValue& b) { return morton_less(a.cell, b.cell); });
      return list;
    };
    ASSERT_EQ(in_order(unordered), expected);
    ASSERT_EQ(in_order(called), expected);
    ASSERT_EQ(count_cells(grid, selection), expected.size());
    if (selection.sphere) {
      ASSERT_EQ(any_occupied(grid, *selection.sphere),
                std::any_of(all.begin(), all.end(), [&](const CellValue& entry) {
                  return grid.rule().occupied(entry.value) &&
                         within(grid, entry.cell, *selection.sphere);
                }));
    }
    filled += expected.empty() ? 0 : 1;
  }
  EXPECT_GT(filled, 100);
}

TEST_P(CellsInLayout, StopWhenAsked) {
  Random random(35);
  const Grid grid = test::clustered_grid(random, {.resolution = 0.25, .layout = GetParam()}, 15);
  int calls = 0;
  for_each_cell(grid, {}, [&](const Cell&, Value) { return ++calls < 5; });
  EXPECT_EQ(calls, 5);
  int batches = 0;
  for_each_batch(grid, {}, [&](std::span<const CellValue>) { return ++batches < 2; });
  EXPECT_EQ(batches, 2);
}

TEST_P(CellsInLayout, OfAnEmptyGridAreNone) {
  const Grid grid({.resolution = 0.25, .layout = GetParam()});
  for (const CellValue& entry : cells(grid)) ADD_FAILURE() << entry.cell.transpose();
  EXPECT_TRUE(grid.bounds().empty());
  EXPECT_FALSE(any_occupied(grid, {.center = {0, 0, 0}, .radius = 1}));
}

TEST_P(CellsInLayout, RefuseSelectionsThatMeanNothing) {
  const Grid grid({.resolution = 0.25, .layout = GetParam()});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(cells(grid, {.sphere = Sphere{.center = {0, 0, 0}, .radius = -1}}), Error);
  EXPECT_THROW(cells(grid, {.sphere = Sphere{.center = {0, nan, 0}, .radius = 1}}), Error);
  EXPECT_THROW(any_occupied(grid, {.center = {0, 0, 0}, .radius = nan}), Error);
  EXPECT_THROW(cells(grid, {.box = Box{.min = {0, 0, 0}, .max = {0, 1, 1}}}), Error);
}

// A ball that only touches the face of a cell does not collide with it.
TEST_P(CellsInLayout, ATouchingBallIsFree) {
  Grid grid({.resolution = 1, .layout = GetParam()});
  grid.set({3, 0, 0}, 0.9);
  EXPECT_FALSE(any_occupied(grid, {.center = {2, 0.5, 0.5}, .radius = 1}));
  EXPECT_TRUE(any_occupied(grid, {.center = {2, 0.5, 0.5}, .radius = 1.001}));
  EXPECT_TRUE(any_occupied(grid, {.center = {3.5, 0.5, 0.5}, .radius = 0.001}));
}

}  // namespace
}  // namespace rmap
