#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"
#include "support/grids.hpp"
#include "support/scans.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

#include <gtest/gtest.h>

#include <rmap/counted_cells.hpp>

namespace rmap {
namespace {

using test::Random;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();

using ByScan = std::map<std::tuple<int, int, int>, std::uint32_t>;

std::vector<CountedCell> listed(const ByScan& plain) {
  std::vector<CountedCell> cells;
  for (const auto& [place, points] : plain) {
    const auto& [z, y, x] = place;
    cells.push_back({{x, y, z}, points});
  }
  return cells;
}

TEST(CountedCells, PointsAreCountedByCell) {
  int compared = 0;
  for (const double resolution : {0.05, 0.3, 1.0}) {
    Random random(static_cast<std::uint64_t>(100 * resolution));
    SCOPED_TRACE(random.trace());
    const Lattice lattice(resolution);
    for (int round = 0; round < 10; ++round, ++compared) {
      const Pose frame = round == 0 ? Pose(Pose::Identity()) : test::random_pose(random, 5);
      std::vector<Vector3f> points;
      for (int i = 0; i < 2000; ++i) points.push_back(random.point(-2, 2).cast<float>());
      points.emplace_back(kNan, 0.0F, 0.0F);
      points.emplace_back(0.0F, -kInfinity, 0.0F);
      points.emplace_back(1e30F, 0.0F, 0.0F);
      ByScan plain;
      for (std::size_t i = 0; i < 2000; ++i) {
        const Vector3d at = lattice.to_cells(transformed(frame, points[i]));
        ++plain[{static_cast<int>(std::floor(at.z())), static_cast<int>(std::floor(at.y())),
                 static_cast<int>(std::floor(at.x()))}];
      }
      std::shuffle(points.begin(), points.end(), random.engine());
      const QuantizedPoints quantized = quantize(points, lattice, frame);
      ASSERT_EQ(quantized.cells, listed(plain));
      ASSERT_EQ(quantized.not_finite, 2u);
      ASSERT_EQ(quantized.beyond_limits, 1u);
    }
  }
  EXPECT_EQ(compared, 30);
}

TEST(CountedCells, OfMorePointsThanAreSortedAtATime) {
  Random random(7);
  SCOPED_TRACE(random.trace());
  constexpr int kPoints = 2'300'000;
  const Lattice lattice(1);
  std::vector<Vector3f> points;
  std::vector<std::uint32_t> plain(20 * 20 * 20);
  for (int i = 0; i < kPoints; ++i) {
    const Cell cell = random.cell(0, 19);
    ++plain[static_cast<std::size_t>((cell.z() * 20 + cell.y()) * 20 + cell.x())];
    points.emplace_back(cell.cast<float>().array() + 0.5F);
  }
  const auto cells = quantize(points, lattice).cells;
  ASSERT_EQ(cells.size(), plain.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const auto index = static_cast<int>(i);
    ASSERT_EQ(cells[i].cell, Cell(index % 20, index / 20 % 20, index / 400));
    ASSERT_EQ(cells[i].points, plain[i]);
  }
}

TEST(CountedCells, AcrossAllLimits) {
  Random random(8);
  SCOPED_TRACE(random.trace());
  const Lattice lattice(1);
  std::vector<Vector3f> points;
  ByScan plain;
  for (int i = 0; i < 3000; ++i) {
    const Vector3f point = random.point(-1e9, 1e9).cast<float>().array().floor();
    for (int copy = i % 3; copy >= 0; --copy) {
      points.push_back(point);
      ++plain[{static_cast<int>(point.z()), static_cast<int>(point.y()),
               static_cast<int>(point.x())}];
    }
  }
  EXPECT_EQ(quantize(points, lattice).cells, listed(plain));
}

TEST(CountedCells, SortedOnesAreAddedUp) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 50; ++seed, ++compared) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    std::vector<CountedCell> cells;
    ByScan plain;
    for (int i = 0; i < 300; ++i) {
      const Cell cell = random.cell(-4, 3);
      const auto points = static_cast<std::uint32_t>(random.integer(0, 9));
      cells.push_back({cell, points});
      plain[{cell.z(), cell.y(), cell.x()}] += points;
    }
    ASSERT_EQ(sorted_cells(cells), listed(plain));
  }
  EXPECT_EQ(compared, 50);
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  EXPECT_EQ(sorted_cells({{{0, 0, 0}, kMost}, {{0, 0, 0}, 3}}).front().points, kMost);
  EXPECT_TRUE(sorted_cells({}).empty());
}

TEST(CountedCells, AreTheOccupiedOnesOfAGrid) {
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    Random random(3);
    SCOPED_TRACE(random.trace());
    const Grid grid = test::clustered_grid(random, {.resolution = 0.2, .layout = layout}, 30);
    ByScan plain;
    for (const auto& [cell, value] : test::all_cell_values(grid)) {
      if (grid.rule().occupied(value)) plain[{cell.z(), cell.y(), cell.x()}] = 1;
    }
    ASSERT_GT(plain.size(), 50u);
    EXPECT_EQ(occupied_cells(grid), listed(plain));
    EXPECT_TRUE(occupied_cells(Grid(Options{.resolution = 0.2})).empty());
  }
}

}  // namespace
}  // namespace rmap
