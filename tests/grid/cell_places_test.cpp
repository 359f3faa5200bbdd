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
    std::vector<Cell> cells;
    const auto cell_of = [&](std::uint32_t place) -> const Cell& { return cells[place]; };
    std::map<Cell, std::uint32_t, test::MortonOrder> expected;
    for (int i = 0; i < 5000; ++i) {
      const Cell cell = random.cell(-reach, reach);
      const auto next = static_cast<std::uint32_t>(expected.size());
      const std::uint32_t place = places.add(cell, CellPlaces::hash_of(cell), cell_of);
      ASSERT_EQ(place, expected.try_emplace(cell, next).first->second);
      if (place == cells.size()) cells.push_back(cell);
    }
    for (const auto& [cell, place] : expected) ASSERT_EQ(places.find(cell, cell_of), place);
    for (int i = 0; i < 5000; ++i) {
      const Cell cell = random.cell(-reach, reach);
      ASSERT_EQ(places.find(cell, cell_of).has_value(), expected.contains(cell));
    }
  }
}

TEST(CellPlaces, TellCellsApartThatHashAlike) {
  CellPlaces places;
  std::vector<Cell> cells;
  const auto cell_of = [&](std::uint32_t place) -> const Cell& { return cells[place]; };
  for (std::uint32_t i = 0; i < 300; ++i) {
    const auto x = static_cast<std::int32_t>(i * CellPlaces::kFactors[1]);
    const auto y = static_cast<std::int32_t>(0U - i * CellPlaces::kFactors[0]);
    const Cell cell(x, y, 0);
    ASSERT_EQ(CellPlaces::hash_of(cell), 0U);
    ASSERT_FALSE(places.find(cell, cell_of).has_value());
    ASSERT_EQ(places.add(cell, 0, cell_of), i);
    cells.push_back(cell);
  }
  for (std::uint32_t i = 0; i < cells.size(); ++i) ASSERT_EQ(places.find(cells[i], cell_of), i);
}

}  // namespace
}  // namespace rmap
