#pragma once

#include "grid/point_tile.hpp"

#include <rmap/box.hpp>

namespace rmap {

/// What the arithmetic of a tile needs, as plain numbers.
struct PointKernelInput {
  /// Row-major 3x4; the identity for points in the map's frame, which `moves` says.
  std::array<double, 12> map_from_points;
  bool moves;
  Vector3d origin;           ///< metres
  Vector3d origin_in_cells;  ///< origin * inverse
  double inverse;            ///< 1 / resolution
  double min_range;
  double max_range;
  TileDetail detail;
};

/// Computes the first `count` places of a tile from `points`, x y z after one
/// another. Where the mask `ends` is set the place is done: a point that passes
/// all filters and ends within the limits. The others are left to the definition.
void compute_points(const PointKernelInput& input, const float* points, std::size_t count,
                    PointTile& tile);

}  // namespace rmap
