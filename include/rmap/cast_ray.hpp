#pragma once

#include <optional>

#include <rmap/grid.hpp>

namespace rmap {

/// The side of a cell through which a ray enters.
enum class Face { none, min_x, max_x, min_y, max_y, min_z, max_z };

/// Where a ray meets the first occupied cell.
struct RayHit {
  Cell cell;
  Vector3d point;   ///< where the ray enters the cell, metres
  Face face;        ///< through which side; of several at once the first of x, y, z; none inside
  double distance;  ///< from the origin to `point`, metres
};

/// The first occupied cell that a ray crosses, or nothing. Crossing means what
/// it means for beams (see Beam): touching a cell from outside is not crossing,
/// and the ray is cut at `max_range`. An infinite range ends at the map's bounds.
///
/// `origin`: metres, map's frame; `direction`: of any length but zero. A ray
/// whose origin lies in an occupied cell (floor) hits it at distance 0, face none,
/// whatever its direction and range.
/// Throws Error(input) for a direction of length zero or not finite or a range
/// that is negative or NaN, Error(limit) for an origin beyond the limits.
/// Cost: by the leaves along the ray up to the hit.
std::optional<RayHit> cast_ray(const Grid& grid, const Vector3d& origin, const Vector3d& direction,
                               double max_range);

}  // namespace rmap
