#pragma once

#include <vector>

#include <rmap/box_query.hpp>

namespace rmap {

/// The map at `factor` times the cell size: each cell that holds an existing
/// cell, with the probability of its cuboid by `criterion` ([RMAP eq. 1] for
/// mean), rounded to the steps of values. Options are the grid's but for the
/// resolution; scans are not carried over. Throws Error(input) unless factor >= 1.
Grid coarsen(const Grid& grid, int factor, Criterion criterion = Criterion::mean);

/// A cube of cells with its occupancy.
struct QueryCuboid {
  CellBox box;
  double mean;             ///< [RMAP eq. 1]
  double max;              ///< largest probability of a cell
  std::uint64_t existing;  ///< existing cells in it, at least 1
};

/// One map at the resolution that each place needs [RMAP 2.2, Fig. 2c]: the
/// existing cells in cubes of 2^n cells, aligned to their own size. A cube is as
/// large as `edge_at` allows at its centre: `edge_at(point)` is the largest edge
/// wanted at a point, in metres; below the resolution it means the resolution.
/// Cubes without an existing cell are left out; they are free by assumption.
/// Disjoint, in Morton order, every existing cell in exactly one.
/// Cost: sorting the cells, then one pass.
std::vector<QueryCuboid> cells_at(const Grid& grid, FunctionRef<double(const Vector3d&)> edge_at);

}  // namespace rmap
