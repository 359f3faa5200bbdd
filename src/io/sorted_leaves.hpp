#pragma once

#include <vector>

#include <rmap/grid.hpp>

namespace rmap {

/// All leaves of a grid in Morton order: those of one block follow one another, and within it
/// the cells come by their positions, whatever the layout.
std::vector<Leaf> sorted_leaves(const Grid& grid);

}  // namespace rmap
