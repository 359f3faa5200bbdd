#include "approximation/cell_blocks.hpp"
#include "approximation/cover_tiles.hpp"
#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"
#include "support/grids.hpp"

#include <gtest/gtest.h>

#include <rmap/cuboid_error.hpp>
#include <rmap/cuboid_map.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

std::vector<CountedCell> sorted(const CellSet& cells) {
  return sorted_cells(test::counted(std::vector<Cell>(cells.begin(), cells.end())));
}

/// Cells near one place that appear, go, or stay as they are.
std::vector<CellState> random_edit(const CellSet& cells, Random& random) {
  std::vector<CellState> edit;
  Cell at = random.cell(-30, 30);
  if (!cells.empty() && random.chance(0.8)) at = *cells.begin() + random.cell(-3, 3);
  const std::int32_t edge = random.integer(1, 7);
  const double density = random.chance(0.3) ? 0 : random.chance(0.3) ? 1 : random.real(0, 1);
  test::for_each_cell_in({.min = at, .max = at + random.cell(1, edge)}, [&](const Cell& cell) {
    edit.push_back({cell, random.chance(density)});
  });
  if (random.chance(0.2)) edit.push_back({random.cell(-4000, 4000), true});
  return edit;
}

TEST(CuboidMap, KeepsItsGuaranteeUnderEdits) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    const int outer = static_cast<int>(seed % 3);
    const int inner = static_cast<int>(seed / 3 % 2);
    const auto first =
        test::moved(test::random_fill(random, 22, random.real(0.05, 0.7)), Cell::Constant(-11));
    CellSet plain = test::set_of(first);
    CuboidMap map(test::counted(first), {.outer = outer, .inner = inner});
    for (int step = 0; step < 25; ++step, ++compared) {
      const auto edit = random_edit(plain, random);
      map.update(edit);
      for (const auto& [cell, occupied] : edit) {
        occupied ? void(plain.insert(cell)) : void(plain.erase(cell));
      }
      ASSERT_EQ(map.cells(), sorted(plain));
      ASSERT_EQ(map.cell_count(), plain.size());
      const auto cuboids = map.cuboids();
      ASSERT_EQ(map.size(), cuboids.size());
      ASSERT_EQ(test::violation(plain, test::boxes_of(cuboids), outer, inner), "");
      const CuboidError error = cuboid_error(map.cells(), cuboids);
      ASSERT_LE(error.farthest_false, outer);
      ASSERT_LE(error.farthest_lost, inner);
    }
    std::size_t counted = 0;
    for (const Cuboid& cuboid : map.cuboids()) {
      std::uint64_t inside = 0;
      for (const Cell& cell : plain) inside += cuboid.cells.contains(cell) ? 1 : 0;
      ASSERT_EQ(cuboid.points, inside);
      ++counted;
    }
    ASSERT_GT(counted, 0u);
  }
  EXPECT_EQ(compared, 12 * 25);
}

// After many small changes there are hardly more cuboids than from scratch.
TEST(CuboidMap, StaysNearTheNumberFromScratch) {
  for (const int outer : {0, 1}) {
    Random random(static_cast<std::uint64_t>(outer));
    SCOPED_TRACE(random.trace());
    const auto first = test::noisy_room(random, 40000, 0.1);
    CellSet plain = test::set_of(first);
    CuboidMap map(test::counted(first), {.outer = outer});
    for (int step = 0; step < 60; ++step) {
      const Cell at = first[random.engine()() % first.size()];
      std::vector<CellState> edit;
      for (int i = 0; i < 12; ++i) edit.push_back({at + random.cell(-2, 2), random.chance(0.5)});
      map.update(edit);
      for (const auto& [cell, occupied] : edit) {
        occupied ? void(plain.insert(cell)) : void(plain.erase(cell));
      }
    }
    ASSERT_EQ(map.cells(), sorted(plain));
    const auto again = cover_by_tiles(CellBlocks(sorted(plain)), {.outer = outer}, 1);
    EXPECT_LE(static_cast<double>(map.size()), 1.15 * static_cast<double>(again.size()));
  }
}

/// Changes of values, flips, new cells, and erased ones.
void change(Grid& grid, Random& random) {
  const Cell at = random.cell(-20, 20);
  for (int i = random.integer(1, 60); i > 0; --i) {
    grid.set(at + random.cell(-5, 5), random.chance(0.5) ? 0.9 : 0.2);
  }
  if (random.chance(0.4)) grid.erase_cells(random.box(-25, 20, 12));
  if (random.chance(0.1)) grid.prune(0.3);
}

TEST(CuboidMap, FollowsAGrid) {
  int compared = 0;
  int incomplete = 0;
  // All flips are remembered, some, or none.
  for (const std::size_t journal : {1000000, 40, 0}) {
    for (const Layout layout : {Layout::blocks, Layout::cells}) {
      Random random(journal + static_cast<std::size_t>(layout));
      SCOPED_TRACE(random.trace());
      Grid grid = test::clustered_grid(random, {.resolution = 0.1, .layout = layout}, 20);
      grid.track_flips(journal);
      CuboidMap map(grid);
      ASSERT_EQ(map.revision(), grid.revision());
      for (int step = 0; step < 30; ++step, ++compared) {
        for (int i = random.integer(0, 3); i > 0; --i) change(grid, random);
        const Changes changes = grid.changes_since(map.revision());
        incomplete += changes.complete ? 0 : 1;
        map.update(changes);
        ASSERT_EQ(map.revision(), grid.revision());
        ASSERT_EQ(map.cells(), occupied_cells(grid));
        ASSERT_EQ(test::violation(test::set_of(map.cells()), test::boxes_of(map.cuboids()), 1, 0),
                  "");
      }
    }
  }
  EXPECT_EQ(compared, 3 * 2 * 30);
  EXPECT_GT(incomplete, 30);
}

// A grid that forgot which blocks went lists those that are.
TEST(CuboidMap, FollowsAGridThatForgotItsBlocks) {
  CuboidMap map(std::vector<CountedCell>{{{0, 0, 0}, 1}, {{50, 0, 0}, 1}, {{51, 0, 0}, 1}});
  map.update(Changes{.revision = 7,
                     .blocks = {{{48, 0, 0}, true}},
                     .blocks_complete = false,
                     .cells = {{{50, 0, 0}, true}, {{52, 0, 0}, false}},
                     .complete = false});
  EXPECT_EQ(map.cells(), (std::vector<CountedCell>{{{50, 0, 0}, 1}}));
  EXPECT_EQ(map.revision(), 7u);
  EXPECT_EQ(map.size(), 1u);
}

TEST(CuboidMap, BeginsWithNothingAndEndsWithNothing) {
  CuboidMap map(std::span<const CountedCell>{});
  EXPECT_EQ(map.size(), 0u);
  map.update(std::vector<CellState>{{{3, 4, 5}, true}, {{3, 4, 6}, true}, {{3, 4, 5}, true}});
  EXPECT_EQ(map.cell_count(), 2u);
  EXPECT_EQ(map.size(), 1u);
  map.update(std::vector<CellState>{{{3, 4, 5}, false}, {{3, 4, 6}, false}, {{9, 9, 9}, false}});
  EXPECT_EQ(map.cell_count(), 0u);
  EXPECT_EQ(map.size(), 0u);
  EXPECT_TRUE(map.cuboids().empty());
}

TEST(CuboidMap, OptionsAreChecked) {
  const std::span<const CountedCell> none;
  EXPECT_THROW(CuboidMap(none, {.outer = 4}), Error);
  EXPECT_THROW(CuboidMap(none, {.inner = -1}), Error);
  EXPECT_THROW(CuboidMap(none, {.threads = -1}), Error);
}

TEST(CuboidMap, StaysAsItWasWhenItRefuses) {
  CuboidMap map(std::vector<CountedCell>{{{0, 0, 0}, 1}}, {.outer = 0});
  EXPECT_THROW(map.update(std::vector<CellState>{
                   {{5, 5, 5}, true}, {{0, 0, 0}, false}, {{kMaxCellIndex + 1, 0, 0}, true}}),
               Error);
  EXPECT_EQ(map.cells(), (std::vector<CountedCell>{{{0, 0, 0}, 1}}));
  EXPECT_EQ(map.size(), 1u);

  Grid grid({.resolution = 0.1});
  grid.track_flips(100);
  CuboidMap of_grid(grid);
  grid.set({1, 2, 3}, 0.9);
  const std::uint64_t between = grid.revision();
  grid.set({4, 5, 6}, 0.9);
  EXPECT_THROW(of_grid.update(grid.changes_since(between)), Error);
  of_grid.update(grid.changes_since(of_grid.revision()));
  EXPECT_EQ(of_grid.cell_count(), 2u);
}

TEST(CuboidMap, ReachesToTheLimits) {
  for (const int outer : {0, 2}) {
    const Cell low = Cell::Constant(kMinCellIndex);
    const Cell high = Cell::Constant(kMaxCellIndex);
    CuboidMap map(std::vector<CountedCell>{{low, 1}}, {.outer = outer});
    map.update(std::vector<CellState>{{high, true}});
    EXPECT_EQ(map.size(), 2u);
    EXPECT_EQ(map.cells(), (std::vector<CountedCell>{{low, 1}, {high, 1}}));
    map.update(std::vector<CellState>{{low, false}});
    EXPECT_EQ(map.size(), 1u);
  }
}

}  // namespace
}  // namespace rmap
