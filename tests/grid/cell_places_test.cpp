#include "grid/cell_places.hpp"

#include "support/plain_grid.hpp"
#include "support/random.hpp"

#include <map>

#include <gtest/gtest.h>

namespace rmap {
namespace {

TEST(CellPlaces, CountInTheOrderInWhichCellsAreMet) {
  test::Random random(75);
  SCOPED_TRACE(random.trace());
  for (const int reach : {2, 30, kMaxCellIndex}) {
    CellPlaces places;
    std::map<Cell, std::uint32_t, test::MortonOrder> expected;
    for (int i = 0; i < 5000; ++i) {
      const Cell cell = random.cell(-reach, reach);
      const auto next = static_cast<std::uint32_t>(expected.size());
      ASSERT_EQ(places.add(cell), expected.try_emplace(cell, next).first->second);
    }
    for (const auto& [cell, place] : expected) ASSERT_EQ(places.at(cell), place);
  }
}

}  // namespace
}  // namespace rmap
