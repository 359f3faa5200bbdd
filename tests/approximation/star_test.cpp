#include "approximation/star.hpp"

#include "approximation/dense_region.hpp"
#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <set>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

TEST(Star, HoldsTheCellsThatFitIntoOneBox) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    const CellBox region{.min = Cell::Zero(),
                         .max = seed % 4 == 0 ? Cell(70, 4, 3) : Cell(7, 8, 6)};
    std::vector<Cell> cells;
    const double density = random.real(0.3, 1);
    for (const Cell& cell : test::solid_box(region)) {
      if (random.chance(density)) cells.push_back(cell);
    }
    const int outer = random.integer(0, 2);
    const DenseRegion dense(cells, region, {.outer = outer});
    BitRows own(dense.allowed().size(), 0);
    for (const Cell& cell : cells) own.set(dense.to_local(cell));
    const CellSet allowed = test::dilated(test::set_of(cells), outer);
    Stars stars(dense.allowed(), own);
    ASSERT_EQ(stars.cell_count(), cells.size());
    std::vector<Cell> places;
    for (std::uint32_t i = 0; i < stars.cell_count(); ++i) {
      places.push_back(dense.to_map(box_of(stars.place(i))).min);
    }
    ASSERT_EQ(test::set_of(places), test::set_of(cells));
    for (std::uint32_t i = 0; i < stars.cell_count(); i += 5, ++compared) {
      std::set<std::uint32_t> star;
      stars.for_each(i, [&](std::uint32_t first, std::uint32_t count) {
        ASSERT_GT(count, 0u);
        for (std::uint32_t other = first; other < first + count; ++other) {
          ASSERT_TRUE(star.insert(other).second);
        }
      });
      // By boxes around both: hence mutual.
      for (std::uint32_t other = 0; other < stars.cell_count(); ++other) {
        const CellBox both = united(box_of(places[i]), box_of(places[other]));
        ASSERT_EQ(star.contains(other), test::holds(allowed, both));
      }
    }
  }
  EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace rmap
