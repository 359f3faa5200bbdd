#include "approximation/ranking.hpp"

#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <algorithm>
#include <unordered_map>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

using Weights = std::unordered_map<Cell, std::uint64_t, CellHash>;

/// Asks each box each time.
std::vector<RankedBox> plain_ranking(Weights left, std::vector<CellBox> boxes, int inner) {
  std::vector<RankedBox> ranking;
  for (;;) {
    RankedBox best;
    for (const CellBox& box : boxes) {
      std::uint64_t gain = 0;
      CellBox bounds;
      for (const auto& [cell, weight] : left) {
        if (!test::grown(box, inner).contains(cell)) continue;
        gain += weight;
        bounds = bounds.empty() ? box_of(cell) : united(bounds, box_of(cell));
      }
      if (gain > best.gain) best = {inner == 0 ? bounds : box, gain};
    }
    if (best.gain == 0) return ranking;
    // With inner 0 the cells outside the bounds are covered already.
    std::erase_if(left, [&](const auto& entry) {
      return test::grown(best.box, inner).contains(entry.first);
    });
    ranking.push_back(best);
  }
}

TEST(Ranking, EqualsAPlainGreedyOne) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    const auto cells = test::counted(test::random_fill(random, 9, 0.3), random, 9);
    std::vector<CellBox> boxes;
    for (int i = 0; i < 25; ++i) boxes.push_back(random.box(-2, 8, 5));
    boxes.push_back(boxes.front());
    for (const CuboidWeight weight : {CuboidWeight::cells, CuboidWeight::points}) {
      Weights weights;
      for (const auto& [cell, points] : cells) {
        weights[cell] = weight == CuboidWeight::cells ? 1 : points;
      }
      for (int inner = 0; inner <= 2; ++inner) {
        const auto ranking = ranked(CellBlocks(cells), boxes, weight, inner);
        const auto expected = plain_ranking(weights, boxes, inner);
        ASSERT_EQ(ranking.size(), expected.size());
        for (std::size_t i = 0; i < ranking.size(); ++i) {
          ASSERT_EQ(ranking[i].gain, expected[i].gain);
          ASSERT_EQ(ranking[i].box, expected[i].box);
        }
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 60 * 2 * 3);
}

TEST(Ranking, GainsNeverRiseAndSumUpToWhatIsCovered) {
  int compared = 0;
  Random random(7);
  SCOPED_TRACE(random.trace());
  for (const auto& [name, cells] : test::small_scenes(random)) {
    SCOPED_TRACE(name);
    const auto counted = test::counted(cells, random, 5);
    std::vector<CellBox> boxes;
    for (int i = 0; i < 120; ++i) {
      const Cell low = cells[random.engine()() % cells.size()] - random.cell(0, 3);
      boxes.push_back({.min = low, .max = low + random.cell(1, 6)});
    }
    for (int inner = 0; inner <= 1; ++inner) {
      const auto ranking = ranked(CellBlocks(counted), boxes, CuboidWeight::points, inner);
      CellSet covered;
      std::uint64_t sum = 0;
      for (std::size_t i = 0; i < ranking.size(); ++i) {
        if (i > 0) {
          ASSERT_LE(ranking[i].gain, ranking[i - 1].gain);
        }
        sum += ranking[i].gain;
        test::for_each_cell_in(test::grown(ranking[i].box, inner),
                               [&](const Cell& cell) { covered.insert(cell); });
        std::uint64_t points = 0;
        for (const auto& [cell, count] : counted) points += covered.contains(cell) ? count : 0;
        ASSERT_EQ(points, sum);
      }
      // In the end as much is covered as by all boxes.
      CellSet all;
      for (const CellBox& box : boxes) {
        test::for_each_cell_in(test::grown(box, inner), [&](const Cell& c) { all.insert(c); });
      }
      std::uint64_t points = 0;
      for (const auto& [cell, count] : counted) points += all.contains(cell) ? count : 0;
      ASSERT_EQ(points, sum);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 15 * 2);
}

}  // namespace
}  // namespace rmap
