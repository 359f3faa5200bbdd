#include "grid/block_kernel.hpp"

#include "grid/block_marks.hpp"
#include "support/random.hpp"
#include "support/simd_targets.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

TEST(EndBlocks, AreTheBlocksOfTheCells) {
  test::Random random(76);
  SCOPED_TRACE(random.trace());
  int compared = 0;
  test::for_each_simd_target([&](const char* target) {
    SCOPED_TRACE(target);
    for (const int reach : {1, 20, 5000, kMaxCellIndex}) {
      PointTile tile;
      tile.count = static_cast<std::size_t>(random.integer(1, PointTile::kSize));
      for (std::size_t i = 0; i < tile.count; ++i) {
        const Cell cell = i == 0 ? Cell::Constant(kMinCellIndex) : random.cell(-reach, reach);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          tile.cell[axis][i] = cell[static_cast<int>(axis)];
        }
      }
      EndBlocks blocks;
      find_end_blocks(tile, blocks);
      for (std::size_t i = 0; i < tile.count; ++i) {
        ASSERT_EQ(blocks.hash[i], BlockMarks::hash_of(block_origin(tile.cell_of(i))));
        ASSERT_EQ(blocks.position[i], block_position(tile.cell_of(i)));
        ++compared;
      }
    }
  });
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace rmap
