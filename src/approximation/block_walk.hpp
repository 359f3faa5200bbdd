#pragma once

#include <rmap/block.hpp>
#include <rmap/cell.hpp>

namespace rmap {

/// use(origin) for each block of 8 x 8 x 8 cells that a box touches, until it returns false: then
/// false too.
template <class Use>
bool for_each_block_of(const CellBox& box, const Use& use) {
  const Cell first = block_origin(box.min);
  Cell at;
  for (at.z() = first.z(); at.z() < box.max.z(); at.z() += kBlockEdge) {
    for (at.y() = first.y(); at.y() < box.max.y(); at.y() += kBlockEdge) {
      for (at.x() = first.x(); at.x() < box.max.x(); at.x() += kBlockEdge) {
        if (!use(std::as_const(at))) return false;
      }
    }
  }
  return true;
}

/// The cells of a block that lie in a box which shares one with it.
inline CellMask positions_in(const Cell& origin, const CellBox& box) {
  // Clipped first: from one end of the indices to the other lie more cells than an int counts.
  const Cell end = origin + Cell::Constant(kBlockEdge);
  const Cell low = box.min.cwiseMax(origin) - origin;
  const Cell high = box.max.cwiseMin(end) - origin;
  return CellsBetween(low, high - Cell::Ones()).mask();
}

}  // namespace rmap
