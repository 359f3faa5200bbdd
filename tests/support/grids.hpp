#pragma once

#include "support/random.hpp"

#include <vector>

#include <rmap/grid.hpp>

namespace rmap::test {

/// Every cell of a grid in Morton order, listed leaf by leaf.
std::vector<CellValue> all_cell_values(const Grid& grid);

/// A grid with clustered random cells of all states within about +-reach cells.
Grid clustered_grid(Random& random, const Options& options, int reach);

/// A hash of the cells and values of a map: equal for equal maps, whatever their
/// layout, compiler or machine.
std::uint64_t map_hash(const Grid& grid);

}  // namespace rmap::test
