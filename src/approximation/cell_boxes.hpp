#pragma once

#include <cstdint>

#include <rmap/cell.hpp>

namespace rmap {

/// The box with so many cells more on every side, within 32 bits.
inline CellBox grown_by(const CellBox& box, std::int32_t cells) {
  return {.min = (box.min.array() - cells).matrix(), .max = (box.max.array() + cells).matrix()};
}

/// Number of cells as a whole number, of a box small enough to be looked at cell by cell.
inline std::int64_t volume_of(const CellBox& box) { return box.extent().prod(); }

}  // namespace rmap
