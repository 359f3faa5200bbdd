#include "approximation/midpoint.hpp"

#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

struct Inside {
  std::size_t count = 0;
  CellBox bounds;
};

Inside inside(const CellSet& cells, const CellBox& box) {
  Inside found;
  for (const Cell& cell : cells) {
    if (!box.contains(cell)) continue;
    found.bounds = found.count == 0 ? box_of(cell) : united(found.bounds, box_of(cell));
    ++found.count;
  }
  return found;
}

TEST(Midpoint, BoxesAreDisjointTightAndFullEnough) {
  int compared = 0;
  Random random(1);
  SCOPED_TRACE(random.trace());
  for (const auto& [name, cells] : test::small_scenes(random)) {
    SCOPED_TRACE(name);
    const CellSet plain = test::set_of(cells);
    const auto sorted = sorted_cells(test::counted(cells));
    std::size_t fewest = 0;
    for (const double fill : {0.2, 0.5, 0.9, 1.0}) {
      for (const std::uint64_t smallest : {1, 8, 100}) {
        const auto boxes = midpoint_boxes(sorted, fill, smallest);
        ASSERT_EQ(test::overlap(boxes), "");
        std::size_t covered = 0;
        for (const CellBox& box : boxes) {
          const Inside found = inside(plain, box);
          ASSERT_EQ(found.bounds, box);
          ASSERT_TRUE(static_cast<double>(found.count) >= fill * box.volume() ||
                      box.volume() <= static_cast<double>(smallest));
          covered += found.count;
        }
        ASSERT_EQ(covered, cells.size());
        if (smallest == 1) {
          ASSERT_GE(boxes.size(), fewest);  // a higher share never needs fewer boxes
          fewest = boxes.size();
        }
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 15 * 4 * 3);
}

TEST(Midpoint, HalvesTheLongestAxis) {
  // The box has 9 places: the lower part gets the first 4.
  const std::vector<CountedCell> cells{
      {{0, 0, 0}, 1}, {{3, 0, 0}, 1}, {{4, 0, 0}, 1}, {{8, 0, 0}, 1}};
  const std::vector<CellBox> expected{{{0, 0, 0}, {1, 1, 1}},
                                      {{3, 0, 0}, {4, 1, 1}},
                                      {{4, 0, 0}, {5, 1, 1}},
                                      {{8, 0, 0}, {9, 1, 1}}};
  EXPECT_EQ(midpoint_boxes(cells, 1, 1), expected);
  EXPECT_EQ(midpoint_boxes(cells, 1, 4).size(), 3u);
  EXPECT_EQ(midpoint_boxes(cells, 0.4, 1).size(), 1u);
  EXPECT_TRUE(midpoint_boxes({}, 1, 1).empty());
}

// The longest axis has more cells than 31 bits count.
TEST(Midpoint, ReachesFromLimitToLimit) {
  const std::vector<CountedCell> cells{{{kMinCellIndex, 0, 0}, 1}, {{kMaxCellIndex, 1, 0}, 1}};
  EXPECT_EQ(midpoint_boxes(cells, 1, 1),
            (std::vector{box_of(cells[0].cell), box_of(cells[1].cell)}));
}

}  // namespace
}  // namespace rmap
