#include "support/grids.hpp"

#include <limits>

#include <gtest/gtest.h>

#include <rmap/crop.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::Random;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Crop, KeepsTheCellsThatTheBoxOverlaps) {
  Random random(82);
  SCOPED_TRACE(random.trace());
  std::size_t kept = 0;
  std::size_t removed = 0;
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    for (int round = 0; round < 20; ++round) {
      Grid grid = test::clustered_grid(random, {.resolution = 0.5, .layout = layout}, 16);
      const auto before = test::all_cell_values(grid);
      Box box{.min = random.point(-8, 4)};
      box.max = box.min + random.point(0.1, 8);
      if (random.chance(0.3)) box.max.z() = kInfinity;
      const CellBox keep = grid.lattice().cells_of(box);
      std::vector<CellValue> expected;
      for (const CellValue& entry : before) {
        if (keep.contains(entry.cell)) expected.push_back(entry);
      }
      ASSERT_EQ(crop(grid, box), before.size() - expected.size());
      ASSERT_EQ(test::all_cell_values(grid), expected);
      ASSERT_EQ(grid.check().value_or(""), "");
      kept += expected.size();
      removed += before.size() - expected.size();
    }
  }
  EXPECT_GT(kept, 300u);
  EXPECT_GT(removed, 1000u);
}

TEST(Crop, RefusesAnEmptyBoxAndLeavesTheGrid) {
  Grid grid({.resolution = 0.5});
  grid.set({1, 2, 3}, 0.9);
  EXPECT_THROW(crop(grid, {.min = {1, 1, 1}, .max = {0, 2, 2}}), Error);
  EXPECT_EQ(grid.cell_count(), 1u);
  EXPECT_EQ(grid.revision(), 1u);
}

}  // namespace
}  // namespace rmap
