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
  int changed = 0;
  int unchanged = 0;
  test::for_each_simd_target([&](const char* target) {
    SCOPED_TRACE(target);
    for (const int reach : {1, 20, 5000, kMaxCellIndex}) {
      PointTile tile;
      tile.count = static_cast<std::size_t>(random.integer(1, PointTile::kSize));
      for (std::size_t i = 0; i < tile.count; ++i) {
        const Cell cell = i == 0               ? Cell::Constant(kMinCellIndex)
                          : random.chance(0.5) ? tile.cell_of(i - 1)
                                               : random.cell(-reach, reach);
        for (std::size_t axis = 0; axis < 3; ++axis) {
          tile.cell[axis][i] = cell[static_cast<int>(axis)];
        }
      }
      EndBlocks blocks;
      find_end_blocks(tile, blocks);
      for (std::size_t i = 0; i < tile.count; ++i) {
        ASSERT_EQ(blocks.hash[i], BlockMarks::hash_of(block_origin(tile.cell_of(i))));
        ASSERT_EQ(blocks.position[i], block_position(tile.cell_of(i)));
        const bool is_same = i > 0 && tile.cell_of(i) == tile.cell_of(i - 1);
        ASSERT_TRUE(blocks.changed.test(i) || is_same);
        // All but the first few places tell.
        if (i >= 16) {
          ASSERT_NE(blocks.changed.test(i), is_same);
          ++(is_same ? unchanged : changed);
        }
        ++compared;
      }
    }
  });
  EXPECT_GT(compared, 100);
  EXPECT_GT(changed, 100);
  EXPECT_GT(unchanged, 100);
}

TEST(TileMask, RunsStartWhereSomethingChanges) {
  test::Random random(77);
  SCOPED_TRACE(random.trace());
  int starts = 0;
  for (int round = 0; round < 50; ++round) {
    PointTile::Mask set;
    PointTile::Mask changed;
    for (std::size_t i = 0; i < PointTile::kSize; ++i) {
      if (random.chance(0.8)) set.set(i);
      if (random.chance(0.3)) changed.set(i);
    }
    const PointTile::Mask found = set.run_starts(changed);
    for (std::size_t i = 0; i < PointTile::kSize; ++i) {
      const bool follows = i > 0 && set.test(i - 1);
      ASSERT_EQ(found.test(i), set.test(i) && (changed.test(i) || !follows)) << i;
      starts += found.test(i) ? 1 : 0;
    }
  }
  EXPECT_GT(starts, 1000);
}

}  // namespace
}  // namespace rmap
