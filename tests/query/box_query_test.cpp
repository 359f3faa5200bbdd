#include "support/grids.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/box_query.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::Random;

// [RMAP eq. 1] by hand: 2 x 2 x 2 cells of which two exist.
TEST(Probability, IsTheMeanOverAllCells) {
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    Grid grid({.resolution = 0.5, .layout = layout});
    grid.set_value({0, 0, 0}, 847);   // 0.69995
    grid.set_value({1, 1, 1}, -405);  // 0.40011
    const double expected = (probability_of(847) + probability_of(-405)) / 8;
    EXPECT_NEAR(probability(grid, {.min = {0, 0, 0}, .max = {1, 1, 1}}), expected, 1e-15);
    EXPECT_NEAR(probability(grid, {.min = {0, 0, 0}, .max = {1, 1, 1}}), 0.1375061, 1e-7);
    EXPECT_EQ(max_probability(grid, {.min = {0, 0, 0}, .max = {1, 1, 1}}), probability_of(847));
    // One cell, an absent cell, all cells of the world.
    EXPECT_EQ(probability(grid, {.min = {0, 0, 0}, .max = {0.5, 0.5, 0.5}}), probability_of(847));
    EXPECT_EQ(probability(grid, {.min = {3, 3, 3}, .max = {4, 4, 4}}), 0);
    const BoxOccupancy all = cell_box_occupancy(grid, all_cells());
    EXPECT_EQ(all.cells, 0x1p93);
    EXPECT_EQ(all.existing, 2u);
    EXPECT_EQ(all.occupied, 1u);
  }
}

TEST(Probability, AbsentCellsCountTheFreeProbability) {
  Grid grid({.resolution = 1, .free_probability = 0.25});
  grid.set_value({0, 0, 0}, 0);
  EXPECT_NEAR(probability(grid, {.min = {0, 0, 0}, .max = {2, 1, 1}}), (0.5 + 0.25) / 2, 1e-15);
  EXPECT_EQ(max_probability(grid, {.min = {1, 0, 0}, .max = {2, 1, 1}}), 0.25);
  grid.set_value({0, 0, 0}, -3000);
  EXPECT_EQ(max_probability(grid, {.min = {0, 0, 0}, .max = {2, 1, 1}}), 0.25);
  EXPECT_LT(max_probability(grid, {.min = {0, 0, 0}, .max = {1, 1, 1}}), 0.05);
}

TEST(BoxOccupancy, EqualsASumOverAllCells) {
  Random random(31);
  SCOPED_TRACE(random.trace());
  int filled = 0;
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    const Options options{.resolution = 0.1, .layout = layout, .free_probability = 0.1};
    const Grid grid = test::clustered_grid(random, options, 15);
    for (int i = 0; i < 400; ++i) {
      const CellBox box = random.box(-20, 15, 14);
      double sum = 0;
      double max = 0;
      std::uint64_t existing = 0;
      std::uint64_t occupied = 0;
      for (int x = box.min.x(); x < box.max.x(); ++x) {
        for (int y = box.min.y(); y < box.max.y(); ++y) {
          for (int z = box.min.z(); z < box.max.z(); ++z) {
            const double p = grid.cell_probability({x, y, z});
            sum += p;
            max = std::max(max, p);
            existing += grid.cell_value({x, y, z}) ? 1 : 0;
            occupied += grid.cell_state({x, y, z}) == State::occupied ? 1 : 0;
          }
        }
      }
      const BoxOccupancy answer = box_occupancy(grid, grid.lattice().metric(box));
      ASSERT_EQ(answer.box, box);
      ASSERT_EQ(answer.cells, box.volume());
      ASSERT_NEAR(answer.mean, sum / box.volume(), 1e-12);
      ASSERT_EQ(answer.max, max);
      ASSERT_EQ(answer.existing, existing);
      ASSERT_EQ(answer.occupied, occupied);
      filled += existing > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(filled, 100);
}

TEST(BoxOccupancy, IsTheSameToTheBitInBothLayouts) {
  Random random(32);
  SCOPED_TRACE(random.trace());
  const Grid blocks = test::clustered_grid(random, {.resolution = 0.1}, 12);
  Grid cells({.resolution = 0.1, .layout = Layout::cells, .max_branches = 5});
  cells.merge(blocks);
  for (int i = 0; i < 300; ++i) {
    const CellBox box = random.box(-20, 12, 20);
    ASSERT_EQ(cell_box_occupancy(blocks, box).mean, cell_box_occupancy(cells, box).mean);
  }
}

TEST(BoxOccupied, DecidesByEitherCriterion) {
  Grid grid({.resolution = 1});
  grid.set({0, 0, 0}, 0.9);
  const Box box{.min = {0, 0, 0}, .max = {2, 2, 2}};
  EXPECT_FALSE(box_occupied(grid, box, Criterion::mean));
  EXPECT_TRUE(box_occupied(grid, box, Criterion::max));
  EXPECT_THROW(box_occupied(grid, {.min = {0, 0, 0}, .max = {0, 1, 1}}, Criterion::max), Error);
  EXPECT_THROW(cell_box_occupancy(grid, {.min = {0, 0, 0}, .max = {0, 1, 1}}), Error);
}

TEST(PointQueries, AnswerManyPointsAsTheyAnswerOne) {
  Random random(33);
  SCOPED_TRACE(random.trace());
  const Grid grid = test::clustered_grid(random, {.resolution = 0.1, .free_probability = 0.2}, 5);
  std::vector<Vector3d> points;
  for (int i = 0; i < 3000; ++i) points.push_back(random.point(-1, 1));
  const auto all_states = states(grid, points);
  const auto all_probabilities = probabilities(grid, points);
  int counts[3] = {};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Cell cell = grid.lattice().cell_of(points[i]);
    const auto value = grid.cell_value(cell);
    const State expected = !value                         ? State::assumed_free
                           : grid.rule().occupied(*value) ? State::occupied
                                                          : State::free;
    ASSERT_EQ(all_states[i], expected);
    ASSERT_EQ(grid.state(points[i]), expected);
    ASSERT_EQ(all_probabilities[i], value ? probability_of(*value) : 0.2);
    ++counts[static_cast<int>(expected)];
  }
  for (const int count : counts) EXPECT_GT(count, 50);
  points.emplace_back(1e15, 0, 0);
  EXPECT_THROW(states(grid, points), Error);
}

}  // namespace
}  // namespace rmap
