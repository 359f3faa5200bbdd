#pragma once

#include <Eigen/Core>

namespace rmap {

using Eigen::Vector3d;
using Eigen::Vector3f;

/// A box in metres in the map's frame, half open: min is inside, max is not.
/// Empty when max <= min on any axis, or when a bound is NaN.
struct Box {
  Vector3d min = Vector3d::Zero();
  Vector3d max = Vector3d::Zero();

  bool empty() const { return !(min.array() < max.array()).all(); }
  bool contains(const Vector3d& point) const {
    return (point.array() >= min.array()).all() && (point.array() < max.array()).all();
  }
  /// The point of the box, its borders included, that is nearest to `point`.
  Vector3d nearest(const Vector3d& point) const { return point.cwiseMax(min).cwiseMin(max); }
};

}  // namespace rmap
