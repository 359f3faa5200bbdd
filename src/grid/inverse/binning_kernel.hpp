#pragma once

#include "grid/point_tile.hpp"

namespace rmap {

/// Where the beams of a tile fall on the cube map, and what casting needs of them.
struct BinnedTile {
  alignas(64) std::array<std::uint32_t, PointTile::kSize> bin;  ///< row * bins + u
  alignas(64) std::array<float, PointTile::kSize> depth;
};

/// Bins the places of a tile that have a beam; the others hold anything. Writes
/// 1 / direction to `inverse`, from which on there must be room for a whole tile.
void bin_beams(const PointTile& tile, int bins, BinnedTile& binned,
               const std::array<float*, 3>& inverse);

}  // namespace rmap
