#pragma once

#include "support/octomap_twin.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>

#include <rmap/cells.hpp>
#include <rmap/octomap_file.hpp>

namespace rmap::test {

/// use(cell, log-odds) for each cell that a tree of OctoMap has a leaf for, large leaves taken
/// apart.
template <class Tree, class Use>
void for_each_cell_of(const Tree& tree, Use&& use) {
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    const octomap::OcTreeKey key = leaf.getIndexKey();  // of the lowest cell
    const int edge = 1 << (tree.getTreeDepth() - leaf.getDepth());
    const Cell origin(key[0] - 32768, key[1] - 32768, key[2] - 32768);
    for (int z = 0; z < edge; ++z) {
      for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) use(Cell(origin + Cell(x, y, z)), leaf->getLogOdds());
      }
    }
  }
}

/// How many cells that are.
template <class Tree>
std::size_t cell_count_of(const Tree& tree) {
  std::size_t count = 0;
  for_each_cell_of(tree, [&](const Cell&, float) { ++count; });
  return count;
}

/// All cells of a grid are leaves of a tree of OctoMap, in the same states (there occupied is at
/// or above 0) with the same log-odds within 1/1000.
template <class Tree>
void expect_same_leaves(const Grid& grid, const Tree& tree) {
  EXPECT_DOUBLE_EQ(grid.lattice().resolution(), tree.getResolution());
  std::size_t found = 0;
  std::size_t other_state = 0;
  double largest = 0;
  for_each_cell_of(tree, [&](const Cell& cell, float log_odds) {
    const auto value = grid.cell_value(cell);
    if (!value) return;
    ++found;
    if (grid.rule().occupied(*value) != (log_odds >= 0)) ++other_state;
    largest = std::max(largest, std::abs(*value / 1000.0 - static_cast<double>(log_odds)));
  });
  EXPECT_EQ(found, grid.cell_count());
  EXPECT_EQ(other_state, 0u);
  EXPECT_LE(largest, 0.00101);
}

}  // namespace rmap::test
