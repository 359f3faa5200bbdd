#pragma once

#include <span>

#include <rmap/cell.hpp>

namespace rmap {

/// A number of cells, exact for every box within the limits.
__extension__ using CellCount = unsigned __int128;

/// Number of cells in `box`.
CellCount cells_in(const CellBox& box);
/// Number of cells that lie in at least one of `boxes`, each counted once. Takes up to n^3 steps
/// for n boxes.
CellCount cells_in_union(std::span<const CellBox> boxes);

}  // namespace rmap
