#include "approximation/cell_blocks.hpp"

#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <limits>
#include <map>
#include <vector>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

// A box near one of the cells, small, large, or far larger than the set.
CellBox box_near(const std::vector<Cell>& cells, Random& random) {
  const Cell at = cells[random.engine()() % cells.size()];
  const std::int32_t reach = random.chance(0.5) ? 3 : random.chance(0.5) ? 20 : 500000;
  return {.min = at - random.cell(0, reach), .max = at + random.cell(1, reach)};
}

TEST(CellBlocks, AreASetWithNumbersAndPoints) {
  Random random(1);
  SCOPED_TRACE(random.trace());
  int compared = 0;
  for (const auto& [name, cells] : test::small_scenes(random)) {
    SCOPED_TRACE(name);
    std::vector<CountedCell> input = test::counted(cells, random, 5);
    for (std::size_t i = 0; i < cells.size(); i += 3) input.push_back(input[i]);  // repeated
    const CellSet plain = test::set_of(cells);
    std::map<Cell, std::uint32_t, decltype(&morton_less)> points(&morton_less);
    CellBox bounds = box_of(cells.front());
    for (const auto& [cell, count] : input) {
      points[cell] += count;
      bounds = united(bounds, box_of(cell));
    }
    const CellBlocks blocks(input);
    ASSERT_EQ(blocks.size(), cells.size());
    ASSERT_EQ(blocks.bounds(), bounds);
    for (int round = 0; round < 60; ++round, ++compared) {
      const CellBox box = box_near(cells, random);
      std::int64_t expected = 0;
      for (const Cell& cell : cells) expected += box.contains(cell) ? 1 : 0;
      CellSet visited;
      blocks.for_each(box, [&](const Cell& cell, std::size_t number) {
        ASSERT_TRUE(box.contains(cell) && visited.insert(cell).second);
        ASSERT_EQ(blocks.points(number), points.at(cell));
      });
      ASSERT_EQ(static_cast<std::int64_t>(visited.size()), expected);
      ASSERT_EQ(blocks.count(box), expected);
      ASSERT_EQ(blocks.overlaps(box), expected > 0);
      const CellBox small = intersection(box, test::grown(box_of(box.min), 4));
      ASSERT_EQ(blocks.holds(small), test::holds(plain, small));
      ASSERT_EQ(blocks.contains(box.min), plain.contains(box.min));
    }
    std::vector<bool> numbers(cells.size());
    blocks.for_each(bounds, [&](const Cell&, std::size_t number) { numbers.at(number) = true; });
    ASSERT_EQ(std::count(numbers.begin(), numbers.end(), true),
              static_cast<std::ptrdiff_t>(cells.size()));
  }
  EXPECT_EQ(compared, 15 * 60);
}

TEST(CellBlocks, HoldAFullBoxAndNoneWithAHole) {
  const CellBox box{.min = {-9, -1, 6}, .max = {12, 17, 15}};
  std::vector<Cell> cells = test::solid_box(box);
  EXPECT_TRUE(CellBlocks(test::counted(cells)).holds(box));
  EXPECT_FALSE(CellBlocks(test::counted(cells)).holds(test::grown(box, 1)));
  cells.erase(cells.begin() + 1234);
  EXPECT_FALSE(CellBlocks(test::counted(cells)).holds(box));
  EXPECT_FALSE(CellBlocks().holds(box));
  EXPECT_FALSE(CellBlocks().overlaps(all_cells()));
}

TEST(CellBlocks, PointsStayAtTheirLimit) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  const CellBlocks blocks(std::vector<CountedCell>{{{1, 2, 3}, kMost - 1}, {{1, 2, 3}, 5}});
  EXPECT_EQ(blocks.size(), 1u);
  EXPECT_EQ(blocks.points(0), kMost);
}

TEST(CellBlocks, DilatedOnesEqualTheCubesAroundAllCells) {
  Random random(2);
  SCOPED_TRACE(random.trace());
  int compared = 0;
  for (const auto& [name, cells] : test::small_scenes(random)) {
    SCOPED_TRACE(name);
    const CellBlocks blocks(test::counted(cells));
    for (int distance = 0; distance <= 3; ++distance, ++compared) {
      const CellSet expected = test::dilated(test::set_of(cells), distance);
      const CellBlocks dilated = blocks.dilated(distance);
      ASSERT_EQ(dilated.size(), expected.size());
      dilated.for_each(dilated.bounds(), [&](const Cell& cell, std::size_t number) {
        ASSERT_TRUE(expected.contains(cell));
        ASSERT_EQ(dilated.points(number), 1u);
      });
    }
  }
  EXPECT_EQ(compared, 15 * 4);
}

// From one end of the indices to the other lie more blocks than 64 bits count.
TEST(CellBlocks, ReachFromLimitToLimit) {
  const std::vector<Cell> cells{Cell::Constant(kMinCellIndex), Cell(1, 2, 3),
                                Cell::Constant(kMaxCellIndex)};
  for (int distance = 0; distance <= 3; ++distance) {
    const CellBlocks blocks = CellBlocks(test::counted(cells)).dilated(distance);
    const std::int64_t edge = 2 * distance + 1;
    EXPECT_EQ(blocks.count(blocks.bounds()), 3 * edge * edge * edge);
    EXPECT_EQ(blocks.count(all_cells()),
              edge * edge * edge + 2 * (distance + 1) * (distance + 1) * (distance + 1));
    CellSet visited;
    blocks.for_each(blocks.bounds(), [&](const Cell& cell, std::size_t) { visited.insert(cell); });
    EXPECT_EQ(visited, test::dilated(test::set_of(cells), distance));
  }
}

}  // namespace
}  // namespace rmap
