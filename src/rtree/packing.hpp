#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/rtree/options.hpp>

namespace rmap {

/// The order of `boxes` in which runs of `run` consecutive ones are good nodes.
///
/// Sort-tile-recursive [Leutenegger, Lopez, Edgington 1997]: of P runs to be, sorted by the
/// centres' x and cut into about P^(1/3) slabs of whole runs, each slab sorted by y and cut
/// into tiles, each tile sorted by z. Hilbert [Kamel, Faloutsos 1993]: along hilbert_less.
std::vector<std::uint32_t> packed_order(std::span<const CellBox> boxes, std::size_t run,
                                        Packing packing);

/// Length of the next run when `remaining` boxes are left: `max` as long as that leaves either
/// none or at least `min`. At the last but one run it leaves exactly `min`; max >= 2 * min.
std::size_t next_run(std::size_t remaining, std::size_t min, std::size_t max);

/// A point's place on the 3D Hilbert curve that fills the cube of all 32-bit coordinates: bit b
/// of the three words, the first the most significant, is the curve's octal digit of that level.
using HilbertPlace = std::array<std::uint32_t, 3>;

/// Skilling's algorithm, "Programming the Hilbert curve" (2004), with all 32 bits an axis: exact.
HilbertPlace hilbert_place(std::array<std::uint32_t, 3> point);
bool hilbert_less(const HilbertPlace& a, const HilbertPlace& b);

}  // namespace rmap
