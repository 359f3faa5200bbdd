// Scenes whose truth is known: what is there is occupied, and nothing else.
#include "support/grids.hpp"
#include "support/plain_grid.hpp"
#include "support/scans.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include <rmap/cells.hpp>
#include <rmap/simulation.hpp>

namespace rmap {
namespace {

using test::PlainGrid;
using test::Random;

Grid built(const Simulation& simulation, const Options& options) {
  Grid grid(options);
  for (const Scan& scan : simulation) grid.prepare(scan);
  for (const Scan& scan : simulation) grid.insert(scan);
  return grid;
}

// How far a cell's cube is from the true surface, at least.
double gap(const Grid& grid, const Scene& scene, const Cell& cell, double time) {
  const double half_diagonal = grid.options().resolution * std::sqrt(3.0) / 2;
  return scene.distance_to_surface(grid.lattice().center(cell), time) - half_diagonal;
}

TEST(SimulatedScans, ABoxIsOccupiedWhereItIsAndNowhereElse) {
  const Simulation simulation = make_simulation("box", {.noise = 0.0});
  const double end = simulation.time(simulation.size() - 1);
  const Grid grid = built(simulation, {.resolution = 0.1});
  std::size_t occupied = 0;
  for (const auto& [cell, value] : cells(grid, {.occupied_only = true})) {
    // Nowhere beyond one cell of the surface.
    EXPECT_LE(gap(grid, simulation.scene(), cell, end), 1e-6) << cell.transpose();
    ++occupied;
  }
  EXPECT_GT(occupied, 500u);

  // Every part of the surface that a beam reached is occupied, or its neighbour is.
  std::size_t samples = 0;
  std::size_t covered = 0;
  for (const Scan& scan : simulation) {
    for (const Vector3f& point : scan.points) {
      const Vector3d place = transformed(scan.map_from_sensor, point);
      covered += any_occupied(grid, {.center = place, .radius = 0.1}) ? 1 : 0;
      ++samples;
    }
  }
  EXPECT_EQ(covered, samples);
  EXPECT_GT(samples, 1000u);
}

TEST(SimulatedScans, AMovingObjectIsGoneAtTheEnd) {
  const Simulation simulation = make_simulation("moving", {.noise = 0.0});
  const double end = simulation.time(simulation.size() - 1);
  Grid grid({.resolution = 0.1});
  std::size_t most_ghosts = 0;
  std::size_t ghosts = 0;
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    grid.insert(simulation.scan(i));
    ghosts = 0;
    for (const auto& [cell, value] : cells(grid, {.occupied_only = true})) {
      ghosts += gap(grid, simulation.scene(), cell, end) > 1e-6 ? 1 : 0;
    }
    most_ghosts = std::max(most_ghosts, ghosts);
  }
  EXPECT_GT(most_ghosts, 20u);  // it was in the map
  EXPECT_EQ(ghosts, 0u);        // and it is not any more
}

class SimulatedScene : public testing::TestWithParam<std::string_view> {};
INSTANTIATE_TEST_SUITE_P(Scenes, SimulatedScene,
                         testing::Values("box", "room", "stairs", "street", "moving", "campus"),
                         [](const auto& scene) { return std::string(scene.param); });

// Both layouts, any order of points and the brute-force oracle agree bit for bit.
TEST_P(SimulatedScene, ThinnedScansGiveTheMapOfTheDefinition) {
  Random random(73);
  SCOPED_TRACE(random.trace());
  const Simulation simulation = make_simulation(GetParam(), {.noise = 0.02, .dropped = 0.1});
  for (const double max_range : {std::numeric_limits<double>::infinity(), 3.0}) {
    const Options options{.resolution = 0.2, .max_range = max_range};
    Options in_cells = options;
    in_cells.layout = Layout::cells;
    in_cells.threads = 3;
    PlainGrid plain(options);
    Grid blocks(options);
    Grid single(in_cells);
    InsertReport total;
    for (std::size_t i = 0; i < std::min<std::size_t>(4, simulation.size()); ++i) {
      const Scan whole = simulation.scan(i);
      const std::size_t stride = std::max<std::size_t>(1, whole.points.size() / 250);
      Scan scan = test::thinned(whole, stride);
      scan.no_returns.resize(std::min<std::size_t>(scan.no_returns.size(), 50));
      const InsertReport expected = plain.insert(scan);
      total += expected;
      ASSERT_EQ(blocks.insert(scan), expected);
      ASSERT_EQ(single.insert(test::shuffled(scan, random)), expected);
    }
    EXPECT_EQ(test::difference(blocks, plain), "");
    EXPECT_EQ(test::difference(single, plain), "");
    EXPECT_GT(total.inserted + total.cut, 300u);
  }
}

}  // namespace
}  // namespace rmap
