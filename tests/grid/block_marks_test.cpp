#include "grid/block_marks.hpp"

#include "support/plain_grid.hpp"
#include "support/random.hpp"

#include <set>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using CellSet = std::set<Cell, test::MortonOrder>;

CellSet cells_of(const BlockMarks& marks) {
  CellSet cells;
  for (const BlockMarks::Block& block : marks.blocks()) {
    EXPECT_EQ(block.origin, block_origin(block.origin));
    block.cells.for_each([&](BlockPosition position) {
      EXPECT_TRUE(cells.insert(block.origin + block_offset(position)).second);
    });
  }
  return cells;
}

TEST(BlockMarks, HoldTheCellsThatWereAdded) {
  test::Random random(71);
  SCOPED_TRACE(random.trace());
  for (const int reach : {3, 40, 400, kMaxCellIndex}) {
    BlockMarks marks;
    BlockMarks others;
    CellSet expected;
    for (int i = 0; i < 5000; ++i) {
      const Cell cell = random.cell(-reach, reach);
      (i % 3 == 0 ? others : marks).add(cell);
      expected.insert(cell);
    }
    marks.add(others);
    EXPECT_EQ(cells_of(marks), expected);
    EXPECT_FALSE(marks.find(Cell::Constant(kMinCellIndex - 8)).has_value());
    for (std::size_t i = 0; i < marks.blocks().size(); ++i) {
      ASSERT_EQ(marks.find(marks.blocks()[i].origin), i);
    }
  }
}

}  // namespace
}  // namespace rmap
