#pragma once

#include <vector>

#include <rmap/box_query.hpp>

namespace rmap {

/// The map at `factor` times the cell size: each cell that holds an existing
/// cell, with the probability of its cuboid by `criterion` ([RMAP eq. 1] for
/// mean), rounded to the steps of values. Options and history are the grid's; the
/// poses of its scans are not carried over. Throws Error(input) unless factor >= 1.
///
/// The resolution is what people would write: 0.1 m three times is 0.3 m, not
/// 0.30000000000000004, so that the map fits those built at 0.3 m.
Grid coarsen(const Grid& grid, int factor, Criterion criterion = Criterion::mean);

/// A cube of cells with its occupancy.
struct QueryCuboid {
  CellBox box;
  double mean;             ///< [RMAP eq. 1]
  double max;              ///< largest probability of a cell
  std::uint64_t existing;  ///< existing cells in it, at least 1
};

/// One map at the resolution that each place needs [RMAP 2.2, Fig. 2c]: the
/// existing cells in cubes of 2^n cells, aligned to their own size. `edge_in(box)`
/// is the largest edge that is wanted everywhere in a box, both in metres: a cube
/// that is larger than what is wanted in it comes in its eight octants, down to
/// single cells. The first cubes are the smallest that hold all cells of an octant
/// of the map's axes. Cubes without an existing cell are left out; they are free by
/// assumption. Disjoint, in Morton order, every existing cell in exactly one.
/// Cost: sorting the cells, then one pass.
std::vector<QueryCuboid> cells_at(const Grid& grid, FunctionRef<double(const Box&)> edge_in);

}  // namespace rmap
