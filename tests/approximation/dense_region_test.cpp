#include "approximation/dense_region.hpp"

#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

TEST(DenseRegion, AllowsTheCubesAroundAllCells) {
  int compared = 0;
  for (const std::int32_t length : {1, 9, 55, 56, 57, 58, 59, 60, 61, 62, 63, 64, 65, 120, 127}) {
    for (int outer = 0; outer <= 3; ++outer) {
      for (int inner = 0; inner <= 3; inner += 3, ++compared) {
        Random random(static_cast<std::uint64_t>(length));
        SCOPED_TRACE(random.trace());
        const Cell low = random.cell(-1000, 1000);
        const CellBox region{.min = low, .max = low + Cell(length, 7, 6)};
        std::vector<Cell> cells{region.min, region.max - Cell::Ones()};
        for (const Cell& cell : test::solid_box(region)) {
          if (random.chance(0.03)) cells.push_back(cell);
        }
        const DenseRegion dense(cells, region, {.outer = outer, .inner = inner});
        const CellSet expected = test::dilated(test::set_of(cells), outer);
        const CellBox all{.min = Cell::Zero(), .max = dense.allowed().size()};
        std::size_t allowed = 0;
        test::for_each_cell_in(all, [&](const Cell& local) {
          const Cell cell = dense.to_map(box_of(local)).min;
          ASSERT_EQ(dense.to_local(cell), local);
          for (int axis = 0; axis < 3; ++axis) {
            ASSERT_EQ(dense.allowed().rows(axis).test(local), expected.contains(cell));
          }
          allowed += dense.allowed().test(local) ? 1 : 0;
        });
        ASSERT_EQ(allowed, expected.size());
        // Boxes that a cell's neighbours are covered by have room as well.
        ASSERT_TRUE(dense.places().contains(dense.to_local(test::grown(region, outer + inner))));
        ASSERT_EQ(dense.none().size(), dense.allowed().size());
        ASSERT_EQ(dense.none().count(dense.places()), 0);
        const CellBox box{.min = low, .max = low + Cell::Constant(2)};
        ASSERT_EQ(dense.to_map(dense.to_local(box)), box);
      }
    }
  }
  EXPECT_EQ(compared, 15 * 4 * 2);
}

}  // namespace
}  // namespace rmap
