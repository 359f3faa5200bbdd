#include "support/grids.hpp"

#include <gtest/gtest.h>

#include <rmap/grid.hpp>

namespace rmap {
namespace {

using test::Random;

TEST(Grid, BlockBoundsAreTheBlocksAroundTheBoundsInBothLayouts) {
  Random random(81);
  SCOPED_TRACE(random.trace());
  for (int round = 0; round < 50; ++round) {
    Grid blocks({.resolution = 0.5});
    Grid cells({.resolution = 0.5, .layout = Layout::cells});
    EXPECT_TRUE(blocks.block_bounds().empty());
    EXPECT_TRUE(cells.block_bounds().empty());
    for (int i = random.integer(1, 20); i > 0; --i) {
      const Cell cell =
          random.chance(0.05) ? Cell(random.cell(-1, 0) * kMaxCellIndex) : random.cell(-30, 30);
      blocks.set(cell, 0.9);
      cells.set(cell, 0.9);
    }
    const CellBox bounds = blocks.bounds();
    const CellBox expected{
        .min = block_origin(bounds.min),
        .max = block_origin(bounds.max - Cell::Ones()) + Cell::Constant(kBlockEdge)};
    ASSERT_EQ(blocks.block_bounds(), expected);
    ASSERT_EQ(cells.block_bounds(), expected);
  }
}

}  // namespace
}  // namespace rmap
