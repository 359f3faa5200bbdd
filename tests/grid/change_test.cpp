#include "support/plain_grid.hpp"
#include "support/scans.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/grid.hpp>

namespace rmap {
namespace {

using test::MortonOrder;
using test::Random;
using CellMap = std::map<Cell, Value, MortonOrder>;

CellMap content(const Grid& grid) {
  CellMap cells;
  grid.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each([&](const Cell& cell, Value value) { cells[cell] = value; });
    return true;
  });
  return cells;
}

class ChangeInLayout : public testing::TestWithParam<Layout> {
 protected:
  Options options() const { return {.resolution = 0.5, .layout = GetParam(), .max_branches = 4}; }
};

INSTANTIATE_TEST_SUITE_P(Layouts, ChangeInLayout, testing::Values(Layout::blocks, Layout::cells),
                         [](const auto& layout) {
                           return layout.param == Layout::blocks ? "blocks" : "cells";
                         });

TEST_P(ChangeInLayout, SetEraseAndPruneEqualAPlainMap) {
  Random random(11);
  SCOPED_TRACE(random.trace());
  Grid grid(options());
  CellMap plain;
  int erased = 0;
  for (int step = 0; step < 1500; ++step) {
    const int action = random.integer(0, 99);
    if (action < 80) {
      const Cell cell =
          random.chance(0.02) ? Cell(random.cell(0, 1) * kMaxCellIndex) : random.cell(-20, 20);
      const double p = random.real(0, 1);
      grid.set(cell, p);
      plain[cell] = grid.rule().clamped(value_of(p));
    } else if (action < 95) {
      const CellBox box = random.box(-20, 20, 12);
      const std::size_t count = grid.erase_cells(box);
      EXPECT_EQ(count,
                std::erase_if(plain, [&](const auto& entry) { return box.contains(entry.first); }));
      erased += static_cast<int>(count);
    } else {
      const double p = random.real(0, 0.4);
      EXPECT_EQ(grid.prune(p), std::erase_if(plain, [&](const auto& entry) {
                  return entry.second <= value_of(p);
                }));
    }
    EXPECT_EQ(grid.revision(), static_cast<std::uint64_t>(step) + 1);
    if (step % 10 == 0) {
      ASSERT_EQ(grid.check().value_or(""), "");
      ASSERT_EQ(content(grid), plain);
      ASSERT_EQ(grid.cell_count(), plain.size());
    }
  }
  EXPECT_GT(erased, 150);
}

void set_block(Grid& grid, const Cell& origin, const CellMask& cells,
               std::span<const Value> values) {
  const BlockValues block{origin, cells, values};
  grid.set_blocks({&block, 1});
}

TEST_P(ChangeInLayout, SetBlocksWritesValuesAsTheyAre) {
  Random random(12);
  SCOPED_TRACE(random.trace());
  Grid grid(options());
  CellMap plain;
  for (int step = 0; step < 200; ++step) {
    const Cell origin = random.cell(-2, 2) * kBlockEdge;
    CellMask cells;
    std::vector<Value> values;
    for (BlockPosition position = 0; position < kBlockCells; ++position) {
      if (!random.chance(0.05)) continue;
      cells.set(position);
      values.push_back(static_cast<Value>(random.integer(-32768, 32767)));
      plain[origin + block_offset(position)] = values.back();
    }
    set_block(grid, origin, cells, values);
  }
  EXPECT_EQ(content(grid), plain);
  EXPECT_EQ(grid.check().value_or(""), "");
  const CellMask one = CellMask::single(9);
  const std::vector<Value> value = {5};
  EXPECT_THROW(set_block(grid, {1, 0, 0}, one, value), Error);
  EXPECT_THROW(set_block(grid, {0, 0, 0}, one, {}), Error);
  EXPECT_THROW(set_block(grid, {0, 0, kMaxCellIndex + 1}, one, value), Error);
  const BlockValues first{{0, 0, 0}, one, value};
  const BlockValues second{{8, 0, 0}, one, value};
  for (const auto& wrong : {std::array{second, first}, std::array{first, first}}) {
    EXPECT_THROW(grid.set_blocks(wrong), Error);
  }
  EXPECT_EQ(content(grid), plain);
}

TEST_P(ChangeInLayout, RefusesWhatCannotBeSet) {
  Grid grid(options());
  EXPECT_THROW(grid.set({0, 0, 0}, 1.5), Error);
  EXPECT_THROW(grid.set({0, 0, 0}, std::nan("")), Error);
  try {
    grid.set({3, kMaxCellIndex + 2, 0}, 0.5);
    ADD_FAILURE() << "accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::limit);
    EXPECT_THAT(error.what(), testing::HasSubstr("the cell at (3, 1073741825, 0) is beyond"));
  }
  EXPECT_THROW(grid.prune(-0.5), Error);
  EXPECT_THROW(grid.erase({.min = {0, 0, 0}, .max = {0, 1, 1}}), Error);
  EXPECT_EQ(grid.revision(), 0u);
  EXPECT_TRUE(grid.empty());
}

TEST_P(ChangeInLayout, EraseTakesTheCellsThatABoxOverlaps) {
  Grid grid(options());
  for (int x = 0; x < 10; ++x) grid.set({x, 0, 0}, 0.9);
  EXPECT_EQ(grid.erase({.min = {1.0, 0, 0}, .max = {2.1, 0.1, 0.1}}), 3u);  // cells 2, 3, 4
  EXPECT_EQ(grid.cell_state({1, 0, 0}), State::occupied);
  EXPECT_EQ(grid.cell_state({2, 0, 0}), State::assumed_free);
  EXPECT_EQ(grid.cell_state({4, 0, 0}), State::assumed_free);
  EXPECT_EQ(grid.cell_state({5, 0, 0}), State::occupied);
  EXPECT_EQ(grid.bounds(), (CellBox{.min = {0, 0, 0}, .max = {10, 1, 1}}));
}

// What a follower needs to keep a copy: apply the changes and have the map.
TEST_P(ChangeInLayout, ChangesSinceKeepAFollowerInStep) {
  Random random(13);
  SCOPED_TRACE(random.trace());
  Grid grid(options());
  grid.track_flips(1 << 20);
  std::set<Cell, MortonOrder> follower;
  CellMap before;
  std::uint64_t seen = 0;
  std::size_t changed_blocks = 0;
  for (int step = 0; step < 300; ++step) {
    for (int i = random.integer(0, 2); i >= 0; --i) {
      switch (random.integer(0, 4)) {
        case 0:
          grid.insert(test::random_scan(random, 30, 6));
          break;
        case 1:
          grid.prepare(test::random_scan(random, 10, 6));
          break;
        case 2:
          grid.set(random.cell(-12, 12), random.real(0, 1));
          break;
        case 3:
          grid.erase_cells(random.box(-12, 12, 6));
          break;
        default:
          grid.prune(random.real(0, 0.3));
          break;
      }
    }
    const Changes changes = grid.changes_since(seen);
    ASSERT_TRUE(changes.complete && changes.blocks_complete);
    ASSERT_EQ(changes.revision, grid.revision());
    for (const CellState& cell : changes.cells) {
      if (cell.occupied) {
        follower.insert(cell.cell);
      } else {
        follower.erase(cell.cell);
      }
    }
    const CellMap now = content(grid);
    std::set<Cell, MortonOrder> occupied;
    for (const auto& [cell, value] : now) {
      if (grid.rule().occupied(value)) occupied.insert(cell);
    }
    ASSERT_EQ(follower, occupied);

    // Every block with a difference is named, and says whether it is still there.
    std::set<Cell, MortonOrder> named;
    for (const ChangedBlock& block : changes.blocks) {
      named.insert(block.origin);
      const bool exists = std::any_of(now.begin(), now.end(), [&](const auto& entry) {
        return block_origin(entry.first) == block.origin;
      });
      ASSERT_EQ(block.exists, exists);
    }
    for (const CellMap& map : {before, now}) {
      for (const auto& [cell, value] : map) {
        const auto a = before.find(cell);
        const auto b = now.find(cell);
        if (a == before.end() || b == now.end() || a->second != b->second) {
          ASSERT_TRUE(named.contains(block_origin(cell)));
        }
      }
    }
    changed_blocks += named.size();
    before = now;
    seen = grid.revision();
  }
  EXPECT_GT(changed_blocks, 500u);
}

TEST_P(ChangeInLayout, WithoutAJournalTheChangedBlocksComeWhole) {
  Grid grid(options());
  grid.set({1, 1, 1}, 0.9);
  grid.set({2, 1, 1}, 0.1);
  grid.set({100, 1, 1}, 0.9);
  const std::uint64_t seen = grid.revision();
  grid.set({1, 1, 1}, 0.8);
  const Changes changes = grid.changes_since(seen);
  EXPECT_FALSE(changes.complete);
  EXPECT_TRUE(changes.blocks_complete);
  EXPECT_EQ(changes.blocks, (std::vector<ChangedBlock>{{{0, 0, 0}, true}}));
  EXPECT_EQ(changes.cells, (std::vector<CellState>{{{1, 1, 1}, true}, {{2, 1, 1}, false}}));
  EXPECT_TRUE(grid.changes_since(grid.revision()).blocks.empty());
  EXPECT_THROW(grid.changes_since(grid.revision() + 1), Error);
}

TEST_P(ChangeInLayout, AJournalThatOverflowsSaysSo) {
  Grid grid(options());
  grid.track_flips(3);
  for (int i = 0; i < 5; ++i) grid.set({i, 0, 0}, 0.9);
  EXPECT_FALSE(grid.changes_since(1).complete);
  EXPECT_EQ(grid.changes_since(1).cells.size(), 5u);  // the whole block
  EXPECT_TRUE(grid.changes_since(2).complete);
  EXPECT_EQ(grid.changes_since(2).cells.size(), 3u);
}

TEST_P(ChangeInLayout, ErasedBlocksBeyondMemoryAreAnsweredWithAll) {
  Grid grid(options());
  grid.set({0, 0, 1000}, 0.9);
  for (int i = 0; i < 66000; ++i) {
    grid.set({0, 0, 0}, 0.9);
    grid.erase_cells(box_of(Cell(0, 0, 0)));
  }
  const Changes changes = grid.changes_since(1);
  EXPECT_FALSE(changes.blocks_complete);
  EXPECT_EQ(changes.blocks, (std::vector<ChangedBlock>{{{0, 0, 1000}, true}}));
  EXPECT_TRUE(grid.changes_since(grid.revision() - 4).blocks_complete);
}

TEST_P(ChangeInLayout, ACopyIsIndependent) {
  Random random(14);
  SCOPED_TRACE(random.trace());
  Grid grid(options());
  for (int i = 0; i < 10; ++i) grid.insert(test::random_scan(random, 200, 8));
  const Grid snapshot = grid;
  const CellMap before = content(grid);
  EXPECT_TRUE(same_map(grid, snapshot));
  for (int i = 0; i < 10; ++i) grid.insert(test::random_scan(random, 200, 8));
  grid.erase_cells({.min = {-5, -5, -5}, .max = {5, 5, 5}});
  EXPECT_EQ(content(snapshot), before);
  EXPECT_EQ(snapshot.check().value_or(""), "");
  EXPECT_FALSE(same_map(grid, snapshot));
  Grid assigned(options());
  assigned = snapshot;
  const Grid moved = std::move(assigned);
  EXPECT_TRUE(same_map(moved, snapshot));
  EXPECT_EQ(content(moved), before);
}

TEST_P(ChangeInLayout, HistoryIsCompleteOnlyWhenEveryCellCameBeforeTheFirstScan) {
  Random random(15);
  SCOPED_TRACE(random.trace());
  const Scan first = test::random_scan(random, 50, 5);
  const Scan second = test::random_scan(random, 50, 5);
  Grid grid(options());
  const std::uint64_t made = grid.prepare(first).new_cells;
  EXPECT_EQ(made, grid.cell_count());
  grid.prepare(second);
  EXPECT_EQ(grid.prepare(second).new_cells, 0u);
  grid.insert(first);
  EXPECT_EQ(grid.insert(second).new_cells, 0u);
  EXPECT_EQ(grid.history(), History::complete);
  EXPECT_EQ(grid.scan_poses().size(), 2u);
  grid.prepare(test::random_scan(random, 50, 5));
  EXPECT_EQ(grid.history(), History::first_hit);

  Grid single(options());
  single.insert(first);
  EXPECT_EQ(single.history(), History::first_hit);
}

TEST_P(ChangeInLayout, APreparedCellIsAnExistingCellOfThePrior) {
  Grid grid(options());
  grid.prepare(test::map_scan({0.1, 0.1, 0.1}, {{3.1f, 0.1f, 0.1f}}));
  const Cell cell(6, 0, 0);
  EXPECT_EQ(grid.cell_value(cell), grid.rule().prior());
  EXPECT_EQ(grid.cell_state(cell), State::free);
  EXPECT_EQ(grid.cell_probability(cell), 0.5);
  EXPECT_EQ(grid.insert(test::map_scan({0.1, 0.1, 0.1}, {{5.1f, 0.1f, 0.1f}})).misses, 1u);
  EXPECT_EQ(grid.cell_value(cell), grid.rule().miss(grid.rule().prior()));
}

TEST_P(ChangeInLayout, RestoringRefusesAPoseThatIsNone) {
  Grid grid(options());
  grid.restore(History::complete, {Pose::Identity()});
  Pose bad = Pose::Identity();
  bad.translation().x() = std::numeric_limits<double>::quiet_NaN();
  try {
    grid.restore(History::first_hit, {Pose::Identity(), bad});
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_STREQ(error.what(),
                 "the pose of scan 1 is none: the pose holds a number that is not finite");
  }
  EXPECT_EQ(grid.history(), History::complete);
  EXPECT_EQ(grid.scan_poses().size(), 1u);
}

TEST_P(ChangeInLayout, BytesInUseFollowTheCells) {
  Random random(16);
  SCOPED_TRACE(random.trace());
  Grid grid(options());
  const BytesInUse empty = grid.bytes_in_use();
  EXPECT_LT(empty.total(), 1000u);
  for (int i = 0; i < 20; ++i) grid.insert(test::random_scan(random, 500, 20));
  const BytesInUse full = grid.bytes_in_use();
  EXPECT_GT(full.nodes, empty.nodes);
  EXPECT_GE(full.values, grid.cell_count() * sizeof(Value));
  EXPECT_GE(full.records, 20 * sizeof(Pose));
  EXPECT_EQ(full.total(), full.nodes + full.blocks + full.values + full.records);
  const auto before = content(grid);
  grid.repack();
  EXPECT_LE(grid.bytes_in_use().nodes, full.nodes);
  EXPECT_EQ(content(grid), before);
  EXPECT_EQ(grid.check().value_or(""), "");
}

}  // namespace
}  // namespace rmap
