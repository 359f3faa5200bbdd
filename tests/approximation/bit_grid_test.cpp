#include "approximation/bit_grid.hpp"

#include "approximation/plain_cells.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

// A box inside a grid; long ones so that whole words are asked as well.
CellBox box_within(const Cell& size, Random& random) {
  CellBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = random.integer(0, size[axis] - 1);
    box.max[axis] = random.integer(box.min[axis] + 1, size[axis]);
  }
  return box;
}

TEST(BitGrid, HoldsTheSameCellsInAllRows) {
  int compared = 0;
  for (const Cell& size :
       {Cell(62, 7, 5), Cell(5, 63, 7), Cell(7, 5, 64), Cell(65, 66, 4), Cell(4, 126, 6),
        Cell(6, 127, 4), Cell(128, 4, 6), Cell(5, 6, 129), Cell(130, 5, 5), Cell(3, 3, 3)}) {
    Random random(static_cast<std::uint64_t>(size.sum()));
    SCOPED_TRACE(random.trace());
    const CellBox all{.min = Cell::Zero(), .max = size};
    BitGrid grid(size);
    ASSERT_EQ(grid.size(), size);
    CellSet plain;
    test::for_each_cell_in(all, [&](const Cell& cell) {
      if (random.chance(0.98)) {
        grid.set(cell);
        plain.insert(cell);
      }
    });
    for (int round = 0; round < 60; ++round, ++compared) {
      for (int box_number = 0; box_number < 5; ++box_number) {
        const CellBox box = box_within(size, random);
        std::int64_t count = 0;
        test::for_each_cell_in(box,
                               [&](const Cell& cell) { count += plain.contains(cell) ? 1 : 0; });
        ASSERT_EQ(grid.count(box), count);
        ASSERT_EQ(grid.holds(box), count == box.extent().prod());
      }
      CellBox hole = box_within(size, random);
      hole.max = hole.max.cwiseMin(hole.min + random.cell(1, 3));
      if (round % 3 == 0) {
        grid.reset(hole.min);
        plain.erase(hole.min);
      } else {
        grid.reset(hole);
        test::for_each_cell_in(hole, [&](const Cell& cell) { plain.erase(cell); });
      }
    }
    grid.reset(box_within(size, random));
    test::for_each_cell_in(all, [&](const Cell& cell) {
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(grid.rows(axis).test(cell), grid.test(cell));
      }
    });
  }
  EXPECT_EQ(compared, 10 * 60);
}

}  // namespace
}  // namespace rmap
