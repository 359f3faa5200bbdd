#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <rmap/counted_cells.hpp>

namespace rmap {

/// Cells no two of which fit into one allowed cuboid, and hence a certificate: every list of
/// cuboids that covers all cells has at least so many.
struct CuboidBound {
  std::vector<Cell> independent;

  std::size_t cuboids() const { return independent.size(); }
};

struct CuboidBoundOptions {
  /// As in ApproximationOptions: how far an empty cell of a cuboid may be from an occupied one.
  int outer = 0;
  /// Steps of local search, each a try to put two cells in the place of one, for each cell.
  double steps_per_cell = 20;
  std::uint64_t seed = 1;
};

/// Looks for many such cells: greedily, then by local search. Any result is a valid bound; cuboids
/// must lose no cell (inner 0, sigma 1) for it to apply. The same for the same input. Throws
/// Error(input) when an option is out of range, Error(limit) when the box of the cells has more
/// than 2^33 places. Cost: some microseconds a cell with outer 0, far more with larger ones.
CuboidBound lower_bound(std::span<const CountedCell> cells, const CuboidBoundOptions& options = {});

/// Whether the bound holds: all its cells are in `cells` and no two fit into an allowed cuboid.
/// Asks each pair that is near enough, by another way than lower_bound.
bool verify(const CuboidBound& bound, std::span<const CountedCell> cells, int outer);

}  // namespace rmap
