#pragma once

#include "support/octomap_twin.hpp"

#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>

#include <rmap/cells.hpp>
#include <rmap/octomap_file.hpp>

namespace rmap::test {

/// The log-odds of all cells that a tree of OctoMap has leaves for, large leaves taken apart.
template <class Tree>
std::map<Cell, float, MortonOrder> cell_log_odds(const Tree& tree) {
  std::map<Cell, float, MortonOrder> cells;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const octomap::OcTreeKey key = leaf.getIndexKey();  // of the lowest cell
    const int edge = 1 << (tree.getTreeDepth() - leaf.getDepth());
    const Cell origin(key[0] - 32768, key[1] - 32768, key[2] - 32768);
    for (int z = 0; z < edge; ++z) {
      for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) {
          cells.emplace_hint(cells.end(), origin + Cell(x, y, z), leaf->getLogOdds());
        }
      }
    }
  }
  return cells;
}

/// A grid and a tree of OctoMap have the same cells in the same states, with the same
/// log-odds within 1/1000. Of a tree of OctoMap, occupied is at or above 0.
template <class Tree>
void expect_same_leaves(const Grid& grid, const Tree& tree) {
  EXPECT_DOUBLE_EQ(grid.lattice().resolution(), tree.getResolution());
  std::size_t found = 0;
  std::size_t other_state = 0;
  double largest = 0;
  for (const auto& [cell, log_odds] : cell_log_odds(tree)) {
    const auto value = grid.cell_value(cell);
    if (!value) continue;
    ++found;
    if (grid.rule().occupied(*value) != (log_odds >= 0)) ++other_state;
    largest = std::max(largest, std::abs(*value / 1000.0 - static_cast<double>(log_odds)));
  }
  EXPECT_EQ(found, grid.cell_count());
  EXPECT_EQ(other_state, 0u);
  EXPECT_LE(largest, 0.00101);
}

}  // namespace rmap::test
