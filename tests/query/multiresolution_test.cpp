#include "support/grids.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <rmap/compare.hpp>
#include <rmap/error.hpp>
#include <rmap/multiresolution.hpp>

namespace rmap {
namespace {

using test::Random;

// From (0.1, 0.1, 0.1) to the nearest point of a box.
double distance_from_center(const Box& box) {
  const Vector3d center = Vector3d::Constant(0.1);
  return (box.nearest(center) - center).norm();
}

TEST(Coarsen, GivesEachCoarseCellTheProbabilityOfItsCuboid) {
  Random random(38);
  SCOPED_TRACE(random.trace());
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    const Grid grid = test::clustered_grid(
        random, {.resolution = 0.25, .layout = layout, .free_probability = 0.05}, 20);
    for (const int factor : {1, 2, 3, 8, 11}) {
      for (const Criterion criterion : {Criterion::mean, Criterion::max}) {
        const Grid coarse = coarsen(grid, factor, criterion);
        EXPECT_EQ(coarse.options().resolution, 0.25 * factor);
        EXPECT_EQ(coarse.check().value_or(""), "");
        std::uint64_t covered = 0;
        for (const CellValue& entry : test::all_cell_values(coarse)) {
          const CellBox box{.min = entry.cell * factor,
                            .max = (entry.cell + Cell::Ones()) * factor};
          const BoxOccupancy expected = cell_box_occupancy(grid, box);
          ASSERT_GT(expected.existing, 0u);
          ASSERT_EQ(entry.value,
                    value_of(criterion == Criterion::mean ? expected.mean : expected.max));
          covered += expected.existing;
        }
        EXPECT_EQ(covered, grid.cell_count());
      }
    }
  }
  EXPECT_THROW(coarsen(Grid({.resolution = 1}), 0), Error);
}

// The double nearest to `digits` times 10^-`places`.
double decimal(std::int64_t digits, int places) {
  return std::stod(std::to_string(digits) + "e-" + std::to_string(places));
}

TEST(Coarsen, GivesTheResolutionThatPeopleWrite) {
  int differs = 0;
  int cases = 0;
  for (const int digits : {1, 2, 3, 5, 7, 12, 15, 25, 123, 1234, 99999}) {
    for (const int places : {0, 1, 2, 3, 4}) {
      const Grid grid({.resolution = decimal(digits, places)});
      for (int factor = 1; factor <= 200; ++factor) {
        const double expected = decimal(std::int64_t{digits} * factor, places);
        if (expected > 1e6) break;
        ASSERT_EQ(coarsen(grid, factor).options().resolution, expected)
            << digits << "e-" << places << " x " << factor;
        differs += decimal(digits, places) * factor != expected ? 1 : 0;
        ++cases;
      }
    }
  }
  EXPECT_GT(cases, 8000);
  EXPECT_GT(differs, 300);
  // What is no short decimal is multiplied as it is.
  const double third = 0.1 / 3;
  EXPECT_EQ(coarsen(Grid({.resolution = third}), 1).options().resolution, third);
  EXPECT_EQ(coarsen(Grid({.resolution = third}), 7).options().resolution, third * 7);
}

TEST(Coarsen, FitsAMapBuiltAtTheCoarseResolution) {
  Grid fine({.resolution = 0.1});
  fine.set({3, 4, 5}, 0.9);
  Grid coarse = coarsen(fine, 3, Criterion::max);
  Grid built({.resolution = 0.3});
  built.set({1, 1, 1}, 0.9);
  EXPECT_TRUE(compare(coarse, built).same_cells());
  coarse.merge(built);
  EXPECT_EQ(coarse.cell_count(), 1u);
}

TEST(Coarsen, KeepsTheHistoryAndNoScans) {
  const Scan scan{.points = {{1, 0, 0}, {2, 1, 0}}};
  Grid first_hit({.resolution = 0.1});
  first_hit.insert(scan);
  EXPECT_EQ(coarsen(first_hit, 2).history(), History::first_hit);
  Grid complete({.resolution = 0.1});
  complete.prepare(scan);
  complete.insert(scan);
  EXPECT_EQ(coarsen(complete, 2).history(), History::complete);
  EXPECT_TRUE(coarsen(complete, 2).scan_poses().empty());
}

// How many cells have indices of the same signs as `cell`.
std::uint64_t existing_in_octant(const Grid& grid, const Cell& cell) {
  CellBox octant = all_cells();
  for (int axis = 0; axis < 3; ++axis) (cell[axis] < 0 ? octant.max : octant.min)[axis] = 0;
  return cell_box_occupancy(grid, octant).existing;
}

TEST(CellsAt, CoversEachCellOnceAtTheSizeOfThePlace) {
  Random random(39);
  SCOPED_TRACE(random.trace());
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    Grid grid = test::clustered_grid(random, {.resolution = 0.25, .layout = layout}, 40);
    grid.set({kMinCellIndex, kMaxCellIndex, 0}, 0.9);
    const auto edge_in = [](const Box& place) { return 0.1 + distance_from_center(place) / 12; };
    const auto cuboids = cells_at(grid, edge_in);
    std::uint64_t covered = 0;
    std::size_t sizes[3] = {};
    for (const QueryCuboid& cuboid : cuboids) {
      const BoxOccupancy expected = cell_box_occupancy(grid, cuboid.box);
      ASSERT_GT(cuboid.existing, 0u);
      ASSERT_EQ(cuboid.existing, expected.existing);
      ASSERT_EQ(cuboid.mean, expected.mean);
      ASSERT_EQ(cuboid.max, expected.max);
      covered += cuboid.existing;
      // A cube of 2^n cells, aligned to itself, small enough here, and its parent would not be.
      const std::int64_t edge = cuboid.box.extent().x();
      ASSERT_TRUE((cuboid.box.extent().array() == edge).all());
      ASSERT_EQ(edge & (edge - 1), 0);
      ASSERT_TRUE((cuboid.box.min.cast<std::int64_t>().array().unaryExpr(
                       [&](std::int64_t index) { return index & (edge - 1); }) == 0)
                      .all());
      const auto wanted = [&](const CellBox& box) { return edge_in(grid.lattice().metric(box)); };
      ASSERT_TRUE(edge == 1 || static_cast<double>(edge) * 0.25 <= wanted(cuboid.box) * (1 + 1e-9));
      // Only the first cube of an octant of the axes has no parent.
      if (cuboid.existing < existing_in_octant(grid, cuboid.box.min)) {
        const auto parent_edge = static_cast<std::int32_t>(2 * edge);
        const Cell corner = cuboid.box.min.unaryExpr(
            [&](std::int32_t index) { return index & ~(parent_edge - 1); });
        const CellBox parent{.min = corner, .max = corner + Cell::Constant(parent_edge)};
        ASSERT_GT(parent_edge * 0.25, wanted(parent) * (1 - 1e-9));
      }
      ++sizes[std::min<std::size_t>(2, static_cast<std::size_t>(std::log2(edge)))];
    }
    EXPECT_EQ(covered, grid.cell_count());
    for (const std::size_t size : sizes) EXPECT_GT(size, 0u);
    for (std::size_t i = 1; i < cuboids.size(); ++i) {
      ASSERT_TRUE(morton_less(cuboids[i - 1].box.min, cuboids[i].box.min));
    }
  }
}

// However fast cubes may grow, those near the centre are small.
TEST(CellsAt, IsFineNearTheCentreAndCoarseFarAway) {
  Random random(85);
  SCOPED_TRACE(random.trace());
  Grid grid = test::clustered_grid(random, {.resolution = 0.25}, 59);
  grid.set({0, 0, 0}, 0.9);  // holds the centre
  for (const double growth : {0.05, 0.5, 1.2, 3.0, 1e6}) {
    const auto cuboids =
        cells_at(grid, [&](const Box& place) { return growth * distance_from_center(place); });
    std::int64_t at_center = 0;
    std::int64_t largest = 0;
    for (const QueryCuboid& cuboid : cuboids) {
      const std::int64_t edge = cuboid.box.extent().x();
      const double distance = distance_from_center(grid.lattice().metric(cuboid.box));
      ASSERT_TRUE(edge == 1 || static_cast<double>(edge) * 0.25 <= growth * distance * (1 + 1e-9));
      if (cuboid.box.contains(Cell(0, 0, 0))) at_center = edge;
      largest = std::max(largest, edge);
    }
    EXPECT_EQ(at_center, 1) << growth;
    // Cubes do not reach beyond the smallest one around the map on each side of 0.
    EXPECT_LE(largest, 64);
    if (growth > 1) {
      EXPECT_GE(largest, 32);
    }
  }
}

TEST(CellsAt, StartsWithTheSmallestCubesAroundTheMap) {
  Grid grid({.resolution = 1});
  for (const Cell& cell : {Cell(9, 9, 9), Cell(14, 8, 12), Cell(-1, 0, 0), Cell(-3, 1, 1)}) {
    grid.set(cell, 0.9);
  }
  const auto cuboids = cells_at(grid, [](const Box&) { return 1e12; });
  ASSERT_EQ(cuboids.size(), 2u);
  EXPECT_EQ(cuboids[0].box, (CellBox{.min = {-4, 0, 0}, .max = {0, 4, 4}}));
  EXPECT_EQ(cuboids[1].box, (CellBox{.min = {8, 8, 8}, .max = {16, 16, 16}}));
}

TEST(CellsAt, WithTheFinestSizeEverywhereGivesTheCells) {
  Random random(40);
  SCOPED_TRACE(random.trace());
  const Grid grid = test::clustered_grid(random, {.resolution = 0.25}, 10);
  const auto cuboids = cells_at(grid, [](const Box&) { return 0.0; });
  const auto cells = test::all_cell_values(grid);
  ASSERT_EQ(cuboids.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(cuboids[i].box, box_of(cells[i].cell));
    EXPECT_NEAR(cuboids[i].mean, probability_of(cells[i].value), 1e-15);
  }
  EXPECT_TRUE(cells_at(Grid({.resolution = 1}), [](const Box&) { return 1.0; }).empty());
}

}  // namespace
}  // namespace rmap
