#include "io/files.hpp"
#include "io/octomap_samples.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <rmap/cells.hpp>

namespace rmap {
namespace {

using test::imported;
using test::octomap_header;
using test::value_file;
using test::value_node;
using test::values_to_zero;

/// Where the cells of value_file() come to lie.
Cell cell(int child) { return {child & 1, child >> 1 & 1, child >> 2}; }

TEST(OctomapImport, ValuesAreRoundedTowardsTheStateOfTheLeaf) {
  struct Case {
    float log_odds;
    Value value;
    State state;
  };
  const std::vector<std::vector<Case>> files = {
      {{0.85F, 850, State::occupied},
       {0.8504F, 850, State::occupied},
       {0.8506F, 851, State::occupied},
       {0.0F, 1, State::occupied},  // OctoMap's threshold itself
       {-0.0F, 1, State::occupied},
       {0.0004F, 1, State::occupied},
       {0.0014F, 1, State::occupied},
       {1e-30F, 1, State::occupied}},
      {{-1e-30F, 0, State::free},
       {-0.0004F, 0, State::free},
       {-0.00025F, 0, State::free},
       {-0.0006F, -1, State::free},
       {-0.4055F, -405, State::free},
       {-2.0F, -2000, State::free},
       {-1.9996F, -2000, State::free},
       {3.5F, 3500, State::occupied}},
  };
  int cases = 0;
  for (const auto& expected : files) {
    std::vector<float> log_odds;
    for (const Case& entry : expected) log_odds.push_back(entry.log_odds);
    const OctomapImport map = imported(value_file(log_odds), {.keep_free = true});
    EXPECT_EQ(map.clamped_leaves, 0u);
    EXPECT_EQ(map.changed_leaves, 0u);
    EXPECT_EQ(map.grid.cell_count(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i, ++cases) {
      SCOPED_TRACE(expected[i].log_odds);
      EXPECT_EQ(map.grid.cell_value(cell(static_cast<int>(i))), expected[i].value);
      EXPECT_EQ(map.grid.cell_state(cell(static_cast<int>(i))), expected[i].state);
    }
  }
  EXPECT_EQ(cases, 16);
}

TEST(OctomapImport, ValuesBeyondTheLimitsAreClampedAndCounted) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const std::string file = value_file({3.6F, -2.1F, kInfinity, -kInfinity, 1e30F, 3.5F, -1.5F});
  const OctomapImport map = imported(file, {.keep_free = true});
  const Options defaults;
  const Value max = value_of(defaults.clamp_max);
  const Value min = value_of(defaults.clamp_min);
  const std::vector<Value> expected = {max, min, max, min, max, 3500, -1500};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(map.grid.cell_value(cell(static_cast<int>(i))), expected[i]) << i;
  }
  EXPECT_EQ(map.clamped_leaves, 5u);
  EXPECT_EQ(map.file.max_log_odds, kInfinity);
  EXPECT_EQ(map.file.min_log_odds, -kInfinity);
  // Wider limits keep what they hold.
  const OctomapImport wide =
      imported(file, {.map = {.clamp_min = 0.01, .clamp_max = 0.99}, .keep_free = true});
  EXPECT_EQ(wide.grid.cell_value(cell(0)), 3600);
  EXPECT_EQ(wide.grid.cell_value(cell(1)), -2100);
  EXPECT_EQ(wide.clamped_leaves, 3u);
}

TEST(OctomapImport, LeavesWhoseStateNoValueKeepsAreCounted) {
  // Occupied above log-odds 1.386: 0.5 is free then, whatever it was.
  const OctomapImport map = imported(value_file({0.5F, 1.5F, -0.5F, 1.386F}),
                                     {.map = {.occupied_threshold = 0.8}, .keep_free = true});
  EXPECT_EQ(map.changed_leaves, 1u);
  EXPECT_EQ(map.grid.cell_value(cell(0)), 500);
  EXPECT_EQ(map.grid.cell_state(cell(0)), State::free);
  EXPECT_EQ(map.grid.cell_state(cell(1)), State::occupied);
  EXPECT_EQ(map.grid.cell_value(cell(3)), 1387);  // one step keeps it
}

TEST(OctomapImport, StatesBecomeTheLimits) {
  // Bits 2 and 1 for the first child occupied, bits 4 and 3 for the second one free.
  const auto node = [](unsigned states) { return test::raw(static_cast<std::uint16_t>(states)); };
  std::string nodes = node(3U << 14);
  for (int i = 0; i < 14; ++i) nodes += node(3);
  nodes += node(0b0110);
  const OctomapImport map =
      imported(octomap_header(18, true) + nodes, {.map = {.clamp_min = 0.2}, .keep_free = true});
  EXPECT_TRUE(map.file.states_only);
  EXPECT_EQ(map.grid.cell_value(cell(0)), value_of(map.grid.options().clamp_max));
  EXPECT_EQ(map.grid.cell_value(cell(1)), value_of(0.2));
  EXPECT_EQ(map.clamped_leaves + map.changed_leaves, 0u);
}

TEST(OctomapImport, FreeLeavesAreDroppedOrKept) {
  const std::string file = value_file({1.0F, -1.0F, -1.0F});
  const OctomapImport dropped = imported(file);
  EXPECT_EQ(dropped.grid.cell_count(), 1u);
  EXPECT_EQ(dropped.dropped_free_leaves, 2u);
  EXPECT_EQ(dropped.grid.cell_state(cell(1)), State::assumed_free);
  EXPECT_EQ(dropped.grid.history(), History::first_hit);
  const OctomapImport kept = imported(file, {.keep_free = true});
  EXPECT_EQ(kept.grid.cell_count(), 3u);
  EXPECT_EQ(kept.dropped_free_leaves, 0u);
  EXPECT_EQ(kept.grid.cell_state(cell(1)), State::free);
}

TEST(OctomapImport, LargeLeavesExpandUpToTheLimit) {
  // A leaf at each level from 5 to 0 in a chain of last children, so that they lie side by side.
  for (const int level : {0, 1, 2, 3, 4, 5}) {
    SCOPED_TRACE(level);
    const auto inner = static_cast<std::size_t>(16 - level);
    const std::string file = octomap_header(inner + 2, false) + values_to_zero(inner - 1) +
                             value_node(9, 0b10000001) + value_node(1.0F) + value_node(-1.0F);
    const std::uint64_t cells = std::uint64_t{1} << (3 * level);
    const OctomapImport map = imported(file, {.max_cells = cells});
    EXPECT_EQ(map.grid.cell_count(), cells);
    EXPECT_EQ(map.file.occupied_cells, cells);
    EXPECT_EQ(map.file.free_cells, cells);
    EXPECT_EQ(map.grid.bounds(), (CellBox{.min = Cell::Zero(), .max = Cell::Constant(1 << level)}));
    EXPECT_EQ(map.file.occupied_bounds, map.grid.bounds());
    EXPECT_EQ(map.file.bounds, (CellBox{.min = Cell::Zero(), .max = Cell::Constant(2 << level)}));
    EXPECT_FALSE(map.grid.check());
    EXPECT_EQ(imported(file, {.max_cells = 2 * cells, .keep_free = true}).grid.cell_count(),
              2 * cells);
    EXPECT_THROW(imported(file, {.max_cells = cells - 1}), Error);
    EXPECT_THROW(imported(file, {.max_cells = 2 * cells - 1, .keep_free = true}), Error);
  }
}

TEST(OctomapImport, TheLimitSaysHowToRaiseIt) {
  const test::TemporaryFolder folder;
  const auto file = folder / "map.ot";
  test::write_text(file, value_file({1.0F, 1.0F, -1.0F}));
  test::expect_error(ErrorKind::limit,
                     file.string() +
                         " has 2 occupied cells when its large leaves are expanded, and at most 1 "
                         "are allowed: raise the limit, max_cells (--max-cells), to take them",
                     [&] { import_octomap(file, {.max_cells = 1}); });
}

TEST(OctomapImport, ColoursArePassedOver) {
  std::string nodes;
  for (int i = 0; i < 16; ++i) {
    nodes += test::raw(9.0F) + "rgb" + static_cast<char>(i == 0 ? 0x80 : 1);
  }
  nodes += test::raw(0.5F) + "\xff\x80\x01" + '\0';
  const OctomapImport map = imported(octomap_header(17, false, "0.25", "ColorOcTree") + nodes);
  EXPECT_TRUE(map.file.colors);
  EXPECT_EQ(map.file.id, "ColorOcTree");
  EXPECT_EQ(map.grid.cell_value(Cell::Zero()), 500);
}

TEST(OctomapImport, TheResolutionIsThatOfTheFile) {
  EXPECT_EQ(imported(value_file({1.0F})).grid.lattice().resolution(), 0.25);
  EXPECT_EQ(imported(value_file({1.0F}), {.map = {.resolution = 0.25}}).grid.cell_count(), 1u);
  EXPECT_THROW(imported(value_file({1.0F}), {.map = {.resolution = 0.5}}), Error);
}

TEST(OctomapImport, OptionsDecideHowTheMapLies) {
  const OctomapImport map =
      imported(value_file({1.0F, 2.0F}), {.map = {.layout = Layout::cells, .max_branches = 8}});
  EXPECT_EQ(map.grid.leaf_count(), 2u);
  EXPECT_EQ(map.grid.options().max_branches, 8);
  EXPECT_TRUE(same_map(map.grid, imported(value_file({1.0F, 2.0F})).grid));
}

}  // namespace
}  // namespace rmap
