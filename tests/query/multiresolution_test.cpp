#include <rmap/multiresolution.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <rmap/error.hpp>

#include "support/grids.hpp"

namespace rmap {
namespace {

using test::Random;

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

TEST(CellsAt, CoversEachCellOnceAtTheSizeOfThePlace) {
  Random random(39);
  SCOPED_TRACE(random.trace());
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    Grid grid = test::clustered_grid(random, {.resolution = 0.25, .layout = layout}, 40);
    grid.set({kMinCellIndex, kMaxCellIndex, 0}, 0.9);
    const auto edge_at = [](const Vector3d& point) { return 0.1 + point.norm() / 12; };
    const auto cuboids = cells_at(grid, edge_at);
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
                       [&](std::int64_t index) { return index & (edge - 1); }) == 0).all());
      const auto wanted = [&](const CellBox& box) {
        const Box metric = grid.lattice().metric(box);
        return edge_at((metric.min + metric.max) / 2);
      };
      ASSERT_TRUE(edge == 1 || static_cast<double>(edge) * 0.25 <= wanted(cuboid.box) * (1 + 1e-9));
      if (edge < (1 << 29)) {
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

TEST(CellsAt, WithTheFinestSizeEverywhereGivesTheCells) {
  Random random(40);
  SCOPED_TRACE(random.trace());
  const Grid grid = test::clustered_grid(random, {.resolution = 0.25}, 10);
  const auto cuboids = cells_at(grid, [](const Vector3d&) { return 0.0; });
  const auto cells = test::all_cell_values(grid);
  ASSERT_EQ(cuboids.size(), cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(cuboids[i].box, box_of(cells[i].cell));
    EXPECT_NEAR(cuboids[i].mean, probability_of(cells[i].value), 1e-15);
  }
  EXPECT_TRUE(cells_at(Grid({.resolution = 1}), [](const Vector3d&) { return 1.0; }).empty());
}

}  // namespace
}  // namespace rmap
