#include "approximation/merge_boxes.hpp"

#include "approximation/cover_tiles.hpp"
#include "approximation/plain_cells.hpp"
#include "approximation/runs.hpp"
#include "support/cell_sets.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

TEST(MergeBoxes, LoseNothingAndKeepBothLimits) {
  int compared = 0;
  std::size_t joined = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    for (const auto& [name, cells] : test::small_scenes(random)) {
      SCOPED_TRACE(name);
      const CellSet plain = test::set_of(cells);
      const auto sorted = sorted_cells(test::counted(cells));
      const CellBlocks blocks(sorted);
      const CellBlocks allowed = blocks.dilated(1);
      const CellSet near = test::dilated(plain, 1);
      for (const double max_false : {0.0, 0.1, 0.25, 0.6}) {
        for (const bool limited : {false, true}) {
          for (const auto& boxes : {run_boxes(sorted), cover_by_tiles(blocks, {}, 1)}) {
            const auto merged = merge_boxes(blocks, boxes, max_false, limited ? &allowed : nullptr);
            const CellSet all = test::union_of(merged);
            for (const Cell& cell : cells) ASSERT_TRUE(all.contains(cell));
            const auto volume = static_cast<double>(all.size());
            ASSERT_LE(volume - static_cast<double>(cells.size()), max_false * volume);
            if (limited) {
              for (const CellBox& box : merged) ASSERT_TRUE(test::holds(near, box));
            }
            ASSERT_LE(merged.size(), boxes.size());
            ASSERT_EQ(merge_boxes(blocks, boxes, max_false, limited ? &allowed : nullptr), merged);
            joined += boxes.size() - merged.size();
            ++compared;
          }
        }
      }
    }
  }
  EXPECT_EQ(compared, 3 * 15 * 4 * 2 * 2);
  EXPECT_GT(joined, 10000u);
}

TEST(MergeBoxes, JoinTheCheapestFirst) {
  // Rows of three and two side by side, and two single cells across a corner.
  const std::vector<CellBox> boxes{{{0, 0, 0}, {3, 1, 1}},
                                   {{0, 1, 0}, {2, 2, 1}},
                                   {{20, 0, 0}, {21, 1, 1}},
                                   {{21, 1, 0}, {22, 2, 1}}};
  std::vector<Cell> cells;
  for (const CellBox& box : boxes) {
    for (const Cell& cell : test::solid_box(box)) cells.push_back(cell);
  }
  const CellBlocks blocks(test::counted(cells));
  EXPECT_EQ(merge_boxes(blocks, boxes, 0, nullptr), boxes);
  const auto one = merge_boxes(blocks, boxes, 0.15, nullptr);
  ASSERT_EQ(one.size(), 3u);
  EXPECT_EQ(one.back(), (CellBox{{0, 0, 0}, {3, 2, 1}}));
  EXPECT_EQ(merge_boxes(blocks, boxes, 0.4, nullptr).size(), 2u);
  // Where nothing empty is allowed nothing is joined.
  EXPECT_EQ(merge_boxes(blocks, boxes, 0.4, &blocks), boxes);
}

}  // namespace
}  // namespace rmap
