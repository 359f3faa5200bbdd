#pragma once

#include <Eigen/Geometry>

#include <rmap/box.hpp>

namespace rmap {

/// A rigid transform. `map_from_sensor` carries points of the sensor's frame to
/// the map's. Needs no alignment: a struct with a pose has the same layout
/// whatever the compiler's flags.
using Pose = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

/// Throws Error(input) unless all numbers of the pose are finite and its 3x3
/// part is a rotation: orthonormal to 1e-3, determinant +1.
void check_pose(const Pose& pose);

/// The pose of a translation (metres) and a quaternion, which is normalised.
/// Throws Error(input) when the quaternion is zero or a number is not finite.
Pose make_pose(const Vector3d& translation, const Eigen::Quaterniond& rotation);

/// `map_from_sensor` applied to a point of the sensor's frame: per axis
/// ((r0*x + r1*y) + r2*z) + t, in double and without fused multiply-add, so
/// that every target computes the same map.
Vector3d transformed(const Pose& map_from_sensor, const Vector3f& point);

/// The rotation part alone, in the same arithmetic: for directions.
Vector3d rotated(const Pose& map_from_sensor, const Vector3f& direction);

}  // namespace rmap
