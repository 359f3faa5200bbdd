#pragma once

#include <span>
#include <vector>

#include <rmap/grid.hpp>

namespace rmap {

/// What a grid holds in a cuboid of whole cells [RMAP 2.2].
struct BoxOccupancy {
  CellBox box;                 ///< the cells asked for
  double mean = 0;             ///< [RMAP eq. 1]: mean probability of all cells, absent ones as free
  double max = 0;              ///< the largest probability of a cell, absent ones as free
  double cells = 0;            ///< number of cells in the box, existing or not
  std::uint64_t existing = 0;  ///< cells that exist
  std::uint64_t occupied = 0;  ///< cells that are occupied
};

/// By which number a cuboid is decided [RMAP 2.2].
enum class Criterion { mean, max };

/// Occupancy of the cells that `box` (m) overlaps; borders as in
/// Lattice::cells_of, which also throws for boxes that mean nothing. The sum of
/// eq. 1 is taken in fixed point, so that it does not depend on the layout.
/// Cost: by the leaves that overlap the box, never by its volume.
BoxOccupancy box_occupancy(const Grid& grid, const Box& box);
BoxOccupancy cell_box_occupancy(const Grid& grid, const CellBox& box);

/// [RMAP eq. 1]: the mean probability of the cells in a box (m).
double probability(const Grid& grid, const Box& box);
/// The largest probability of a cell in a box (m).
double max_probability(const Grid& grid, const Box& box);
/// Whether the mean, or the largest, probability of a box (m) is above the grid's threshold.
bool box_occupied(const Grid& grid, const Box& box, Criterion criterion);

/// States and probabilities of many points (m), in their order. Throws
/// Error(limit) when one is beyond the limits.
std::vector<State> states(const Grid& grid, std::span<const Vector3d> points);
std::vector<double> probabilities(const Grid& grid, std::span<const Vector3d> points);

}  // namespace rmap
