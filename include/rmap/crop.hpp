#pragma once

#include <rmap/grid.hpp>

namespace rmap {

/// Keeps the cells that overlap a box (m; borders as in Lattice::cells_of) and removes all
/// others; returns how many went. Throws Error(input) when the box is empty, Error(limit)
/// when it is beyond the limits; the grid is then as it was.
std::size_t crop(Grid& grid, const Box& box);

}  // namespace rmap
