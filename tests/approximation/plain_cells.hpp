#pragma once

#include <span>
#include <string>
#include <unordered_set>
#include <vector>

#include <rmap/counted_cells.hpp>
#include <rmap/cuboids.hpp>

namespace rmap::test {

/// The plain twin of every sparse or dense set of the module.
using CellSet = std::unordered_set<Cell, CellHash>;

template <class Use>
void for_each_cell_in(const CellBox& box, const Use& use) {
  for (std::int32_t z = box.min.z(); z < box.max.z(); ++z) {
    for (std::int32_t y = box.min.y(); y < box.max.y(); ++y) {
      for (std::int32_t x = box.min.x(); x < box.max.x(); ++x) use(Cell(x, y, z));
    }
  }
}

CellBox grown(const CellBox& box, std::int32_t cells);
CellSet set_of(std::span<const Cell> cells);
CellSet set_of(std::span<const CountedCell> cells);
CellSet union_of(std::span<const CellBox> boxes);
std::vector<CellBox> boxes_of(std::span<const Cuboid> cuboids);
/// All cells at most `distance` (Chebyshev) from one of the set.
CellSet dilated(const CellSet& cells, std::int32_t distance);
/// Whether every cell of a box is in the set.
bool holds(const CellSet& cells, const CellBox& box);
/// Chebyshev distance from a cell to a box; 0 inside.
std::int64_t distance(const Cell& cell, const CellBox& box);

/// What is wrong with boxes as an approximation of cells: each box must lie inside the cells
/// dilated by `outer`, and each cell at most `inner` from a box. Empty when nothing is.
std::string violation(const CellSet& cells, std::span<const CellBox> boxes, int outer, int inner);
/// A cell that two boxes share, in words; empty when there is none.
std::string overlap(std::span<const CellBox> boxes);

}  // namespace rmap::test
