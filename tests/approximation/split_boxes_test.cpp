#include "approximation/split_boxes.hpp"

#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

TEST(SplitBoxes, AreDisjointTightAndHoldAllWithFewEnoughEmptyPlaces) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    for (const auto& [name, cells] : test::small_scenes(random)) {
      SCOPED_TRACE(name);
      const CellSet plain = test::set_of(cells);
      const auto sorted = sorted_cells(test::counted(cells));
      for (const double max_false : {0.0, 0.1, 0.25, 0.5, 0.9}) {
        const auto boxes = split_boxes(sorted, max_false);
        ASSERT_EQ(test::overlap(boxes), "");
        double volume = 0;
        std::size_t held = 0;
        for (const CellBox& box : boxes) {
          CellBox bounds;
          for (const Cell& cell : cells) {
            if (!box.contains(cell)) continue;
            bounds = bounds.empty() ? box_of(cell) : united(bounds, box_of(cell));
            ++held;
          }
          ASSERT_EQ(bounds, box);
          volume += box.volume();
        }
        ASSERT_EQ(held, cells.size());
        ASSERT_LE(volume - static_cast<double>(cells.size()), max_false * volume);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 4 * 15 * 5);
}

TEST(SplitBoxes, PeelSlabs) {
  const CellBox box{.min = {-3, 4, -5}, .max = {9, 18, 17}};
  const auto cut = [](const std::vector<Cell>& cells, double max_false) {
    return split_boxes(sorted_cells(test::counted(cells)), max_false);
  };
  EXPECT_EQ(cut(test::solid_box(box), 0), std::vector{box});
  EXPECT_EQ(cut(test::hollow_box(box), 0).size(), 6u);
  EXPECT_EQ(cut(test::hollow_box(box), 0.99), std::vector{box});
  EXPECT_TRUE(split_boxes({}, 0.5).empty());
}

// Memory goes by the cells, not by how far apart they are.
TEST(SplitBoxes, ReachFromLimitToLimit) {
  const std::vector<CountedCell> cells{
      {Cell::Constant(kMinCellIndex), 1}, {{0, 0, 0}, 1}, {Cell::Constant(kMaxCellIndex), 1}};
  const auto boxes = split_boxes(cells, 0.5);
  ASSERT_EQ(boxes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(boxes[i], box_of(cells[i].cell));
}

}  // namespace
}  // namespace rmap
