#pragma once

#include "grid/point_tile.hpp"

namespace rmap {

/// Where the points of a tile end, in terms of blocks.
struct EndBlocks {
  alignas(64) std::array<std::uint32_t, PointTile::kSize> hash;      ///< BlockMarks::hash_of
  alignas(64) std::array<std::uint32_t, PointTile::kSize> position;  ///< block_position
  /// Where the cell is another than that of the place before; the first places always.
  PointTile::Mask changed;
};

/// Computes them for all places that hold a point.
void find_end_blocks(const PointTile& tile, EndBlocks& blocks);

}  // namespace rmap
