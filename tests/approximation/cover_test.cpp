#include "approximation/cover.hpp"

#include "approximation/dense_region.hpp"
#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

/// One dense grid with a set of cells in it.
struct Task {
  DenseRegion dense;
  BitGrid required;
};

CellBox bounds_of(const std::vector<Cell>& cells) {
  CellBox bounds = box_of(cells.front());
  for (const Cell& cell : cells) bounds = united(bounds, box_of(cell));
  return bounds;
}

Task task_of(const std::vector<Cell>& cells, const CoverLimits& limits) {
  DenseRegion dense(cells, bounds_of(cells), limits);
  BitGrid required = dense.none();
  for (const Cell& cell : cells) required.set(dense.to_local(cell));
  return {std::move(dense), std::move(required)};
}

std::vector<CellBox> covered(const std::vector<Cell>& cells, const CoverLimits& limits) {
  Task task = task_of(cells, limits);
  std::vector<CellBox> boxes = cover(task.dense.allowed(), task.required, limits, {});
  EXPECT_EQ(task.required.count(task.dense.places()), 0);
  for (CellBox& box : boxes) box = task.dense.to_map(box);
  return boxes;
}

TEST(Cover, KeepsItsLimits) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    for (const auto& [name, cells] : test::small_scenes(random)) {
      if (name == "far_clusters") continue;  // not for one grid
      SCOPED_TRACE(name);
      const CellSet plain = test::set_of(cells);
      for (int outer = 0; outer <= 2; ++outer) {
        for (int inner = 0; inner <= 1; ++inner) {
          for (const bool reshape : {false, true}) {
            const CoverLimits limits{.outer = outer, .inner = inner, .reshape = reshape};
            const auto boxes = covered(cells, limits);
            ASSERT_EQ(test::violation(plain, boxes, outer, inner), "");
            ASSERT_EQ(covered(cells, limits), boxes);
            ASSERT_LE(boxes.size(), cells.size());
            ++compared;
          }
        }
      }
    }
  }
  EXPECT_EQ(compared, 3 * 14 * 3 * 2 * 2);
}

TEST(Cover, FindsTheFewestWhereTheyAreKnown) {
  const CellBox box{.min = {-9, 3, 60}, .max = {70, 12, 71}};
  EXPECT_EQ(covered(test::solid_box(box), {}), std::vector{box});
  EXPECT_EQ(covered(test::solid_box(box), {.outer = 1}), std::vector{test::grown(box, 1)});
  EXPECT_EQ(covered(test::hollow_box(box), {}).size(), 6u);
  EXPECT_EQ(covered(test::stairs(6), {}).size(), 6u);
  EXPECT_EQ(covered(test::diagonal_plane(9), {}).size(), test::diagonal_plane(9).size());
  EXPECT_EQ(covered({{5, -6, 7}}, {}), std::vector{box_of({5, -6, 7})});
}

// No box is left without a cell that only it covers.
TEST(Cover, NeedsEachOfItsBoxes) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    const auto cells = test::random_fill(random, 9, random.real(0.3, 0.95));
    const auto boxes = covered(cells, {});
    for (const CellBox& box : boxes) {
      bool needed = false;
      for (const Cell& cell : cells) {
        if (!box.contains(cell)) continue;
        needed |= std::count_if(boxes.begin(), boxes.end(),
                                [&](const CellBox& other) { return other.contains(cell); }) == 1;
      }
      ASSERT_TRUE(needed);
      ++compared;
    }
  }
  EXPECT_GT(compared, 500);
}

TEST(Cover, StandsByBoxesThatItBeginsWith) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    const auto cells = test::random_fill(random, 10, random.real(0.4, 0.95));
    const CoverLimits limits{.outer = random.integer(0, 1), .inner = random.integer(0, 1)};
    Task task = task_of(cells, limits);
    std::vector<CellBox> first;
    for (const CellBox& box : covered(cells, limits)) {
      if (random.chance(0.7)) first.push_back(task.dense.to_local(box));
    }
    auto boxes = cover(task.dense.allowed(), task.required, limits, first);
    ASSERT_EQ(task.required.count(task.dense.places()), 0);
    for (CellBox& box : boxes) box = task.dense.to_map(box);
    ASSERT_EQ(test::violation(test::set_of(cells), boxes, limits.outer, limits.inner), "");
    ++compared;
  }
  EXPECT_EQ(compared, 30);
}

}  // namespace
}  // namespace rmap
