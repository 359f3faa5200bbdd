#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/grid.hpp>
#include <rmap/lattice.hpp>
#include <rmap/pose.hpp>

namespace rmap {

/// An occupied cell, and how many points lie in it: one at least; what is beyond 2^32 - 1 is not
/// counted.
struct CountedCell {
  Cell cell;
  std::uint32_t points = 1;

  friend bool operator==(const CountedCell&, const CountedCell&) = default;
};

/// The cells of a cloud.
struct QuantizedPoints {
  std::vector<CountedCell> cells;   ///< each once, by z, then y, then x
  std::uint64_t not_finite = 0;     ///< points that lie nowhere
  std::uint64_t beyond_limits = 0;  ///< points beyond the limits of cell indices
};

/// Quantises points (m) to cells of a lattice, after `frame`, from their frame to that of the
/// lattice. The order of the points does not matter. Cost: some 40 ns a point, sorting
/// included.
QuantizedPoints quantize(std::span<const Vector3f> points, const Lattice& lattice,
                         const Pose& frame = Pose::Identity());

/// The occupied cells of a map, with one point each; in the same order.
std::vector<CountedCell> occupied_cells(const Grid& grid);

/// Throws Error(limit) naming a cell beyond the limits of cell indices, Error(input) one without
/// points. All that takes cells does so.
void check_cells(std::span<const CountedCell> cells);

/// Cells in any order and repeated, as `quantize` gives them: points of equal cells are added.
std::vector<CountedCell> sorted_cells(std::vector<CountedCell> cells);

}  // namespace rmap
