#include "io/files.hpp"
#include "io/map_samples.hpp"
#include "support/grids.hpp"

#include <gtest/gtest.h>

#include <rmap/cells.hpp>
#include <rmap/compare.hpp>
#include <rmap/error.hpp>
#include <rmap/octomap_file.hpp>

namespace rmap {
namespace {

class OctomapExports : public testing::Test {
 protected:
  /// There and back, with the options of the map.
  OctomapImport back(const Grid& grid, const std::string& ending) {
    exported_ = export_octomap(grid, folder_ / ("map" + ending));
    return import_octomap(folder_ / ("map" + ending), {.map = grid.options(), .keep_free = true});
  }

  const test::TemporaryFolder folder_;
  OctomapExport exported_;
};

/// Clusters, single cells at the ends of OctoMap's space, and a cube that is pruned to large
/// leaves.
Grid random_grid(test::Random& random, const Options& options) {
  Grid grid = test::clustered_grid(random, options, 300);
  const UpdateRule& rule = grid.rule();
  const auto set = [&](const Cell& cell) {
    grid.set_value(cell, rule.clamped(random.integer(-4000, 4000)));
  };
  for (int i = 0; i < 50; ++i) set(random.cell(-32768, 32767));
  for (const Cell& corner :
       {Cell(-32768, -32768, -32768), Cell(32767, 32767, 32767), Cell(-32768, 32767, 0)}) {
    set(corner);
  }
  const Cell origin = random.cell(-20, 20) * 16;
  const Value value = rule.clamped(random.integer(-4000, 4000));
  for (int i = 0; i < 16 * 16 * 16; ++i) {
    grid.set_value(origin + Cell(i % 16, i / 16 % 16, i / 256), value);
  }
  for (const Value near_zero : {Value{-1}, Value{0}, Value{1}}) {
    grid.set_value(Cell(7, 500, near_zero), near_zero);
  }
  return grid;
}

TEST_F(OctomapExports, ValuesComeBackAsTheyWere) {
  int cases = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed, ++cases) {
    test::Random random(seed);
    SCOPED_TRACE(random.trace());
    const Grid grid = random_grid(
        random, {.resolution = random.real(0.01, 2), .clamp_min = 0.03, .clamp_max = 0.99});
    const OctomapImport map = back(grid, ".ot");
    const MapDifference difference = compare(grid, map.grid);
    EXPECT_TRUE(difference.same_cells());
    EXPECT_EQ(difference.both, grid.cell_count());
    EXPECT_EQ(map.clamped_leaves + map.changed_leaves, 0u);
    EXPECT_EQ(exported_.changed_states, 0u);
    EXPECT_EQ(exported_.lost_values, 0u);
    EXPECT_EQ(exported_.occupied_cells + exported_.free_cells, grid.cell_count());
    EXPECT_EQ(exported_.nodes, map.file.nodes);
    EXPECT_EQ(map.grid.lattice().resolution(), grid.lattice().resolution());
  }
  EXPECT_EQ(cases, 20);
}

TEST_F(OctomapExports, StatesComeBackAsTheyWere) {
  int cases = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed, ++cases) {
    test::Random random(seed);
    SCOPED_TRACE(random.trace());
    const Grid grid = random_grid(
        random, {.resolution = 0.1, .occupied_threshold = random.chance(0.5) ? 0.5 : 0.8});
    const OctomapImport map = back(grid, ".bt");
    const MapDifference difference = compare(grid, map.grid);
    EXPECT_EQ(difference.only_a + difference.only_b + difference.state_differs, 0u);
    EXPECT_EQ(difference.value_differs, exported_.lost_values);
    EXPECT_EQ(map.changed_leaves, 0u);
    EXPECT_EQ(map.file.occupied_cells, exported_.occupied_cells);
    EXPECT_EQ(map.file.free_cells, exported_.free_cells);
    // What a .bt holds it holds exactly.
    export_octomap(map.grid, folder_ / "again.bt");
    EXPECT_EQ(test::read_text(folder_ / "again.bt"), test::read_text(folder_ / "map.bt"));
  }
  EXPECT_EQ(cases, 20);
}

TEST_F(OctomapExports, WithAnotherThresholdTheStatesThatChangeAreCounted) {
  Grid grid({.resolution = 0.1, .occupied_threshold = 0.8});  // 1386 steps
  const std::vector<Value> values = {-1, 0, 1, 500, 1386, 1387, 2000};
  for (std::size_t i = 0; i < values.size(); ++i) {
    grid.set_value(Cell(static_cast<int>(i), 0, 0), values[i]);
  }
  const OctomapImport map = back(grid, ".ot");
  EXPECT_EQ(exported_.changed_states, 3u);  // free here, occupied for OctoMap: 1, 500, 1386
  EXPECT_EQ(map.changed_leaves, 2u);        // 1386 becomes 1387, and so keeps it
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(map.grid.cell_value(Cell(static_cast<int>(i), 0, 0)),
              values[i] == 1386 ? 1387 : values[i]);
  }
}

TEST_F(OctomapExports, AThresholdBelowOctomapsIsCountedLikewise) {
  Grid grid({.resolution = 0.1, .prob_miss = 0.1, .prior = 0.2, .occupied_threshold = 0.3});
  const std::vector<Value> values = {-900, -847, -846, -500, -1, 0, 5};  // -847 is the threshold
  for (std::size_t i = 0; i < values.size(); ++i) {
    grid.set_value(Cell(static_cast<int>(i), 0, 0), values[i]);
  }
  const OctomapImport map = back(grid, ".ot");
  EXPECT_EQ(exported_.changed_states, 3u);  // occupied here, free for OctoMap: -846, -500, -1
  EXPECT_EQ(map.changed_leaves, 2u);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(map.grid.cell_value(Cell(static_cast<int>(i), 0, 0)),
              values[i] == -846 ? -847 : values[i]);
  }
}

TEST_F(OctomapExports, LayoutsAndOrdersGiveEqualBytes) {
  test::Random random(5);
  SCOPED_TRACE(random.trace());
  const Grid grid = random_grid(random, {.resolution = 0.1});
  Options in_cells = grid.options();
  in_cells.layout = Layout::cells;
  const Grid other = test::rebuilt(grid, random, in_cells);
  for (const char* ending : {".bt", ".ot"}) {
    export_octomap(grid, folder_ / (std::string("a") + ending));
    export_octomap(other, folder_ / (std::string("b") + ending));
    EXPECT_EQ(test::read_text(folder_ / (std::string("a") + ending)),
              test::read_text(folder_ / (std::string("b") + ending)));
  }
}

TEST_F(OctomapExports, AnEmptyMapHasNoNodes) {
  const Grid grid({.resolution = 0.1});
  for (const char* ending : {".bt", ".ot"}) {
    EXPECT_TRUE(back(grid, ending).grid.empty());
    EXPECT_EQ(exported_.nodes, 0u);
  }
}

TEST_F(OctomapExports, CellsBeyondTheKeysAreRefusedByName) {
  int cases = 0;
  for (const Cell& cell : {Cell(32768, 0, 0), Cell(0, -32769, 0), Cell(0, 0, kMaxCellIndex)}) {
    Grid grid({.resolution = 0.1});
    grid.set_value({1, 2, 3}, 1000);
    grid.set_value(cell, 1000);
    for (const char* ending : {".bt", ".ot"}) {
      const auto file = folder_ / (std::string("map") + ending);
      test::write_text(file, "a former file");
      test::expect_error(ErrorKind::limit,
                         "cannot write " + file.string() + ": cell (" + std::to_string(cell.x()) +
                             ", " + std::to_string(cell.y()) + ", " + std::to_string(cell.z()) +
                             ") is beyond what OctoMap can hold: its indices lie in -32768 to "
                             "32767",
                         [&] { export_octomap(grid, file); });
      EXPECT_EQ(test::read_text(file), "a former file");
      ++cases;
    }
  }
  EXPECT_EQ(cases, 6);
  EXPECT_EQ(folder_.names(), (std::vector<std::string>{"map.bt", "map.ot"}));
}

TEST_F(OctomapExports, OtherEndingsAreRefused) {
  test::expect_error(ErrorKind::input,
                     "the ending of " + (folder_ / "map.oct").string() +
                         " is \".oct\", where .bt and .ot are allowed",
                     [&] { export_octomap(Grid({.resolution = 0.1}), folder_ / "map.oct"); });
}

}  // namespace
}  // namespace rmap
