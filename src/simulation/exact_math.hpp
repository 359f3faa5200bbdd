#pragma once

#include <cmath>

#include <rmap/box.hpp>
#include <rmap/pose.hpp>

// Arithmetic that gives the same bits on every target: products of vectors in a
// stated order, since Eigen's depend on the instruction set, and own elementary
// functions, since those of C libraries differ in the last bit.
namespace rmap::simulation {

inline double dot(const Vector3d& a, const Vector3d& b) {
  return (a.x() * b.x() + a.y() * b.y()) + a.z() * b.z();
}

inline double length(const Vector3d& vector) { return std::sqrt(dot(vector, vector)); }

/// `vector` at length 1; it has a length.
inline Vector3d unit(const Vector3d& vector) { return vector / length(vector); }

Vector3d cross(const Vector3d& a, const Vector3d& b);

/// The rotation part of a pose applied to a vector.
inline Vector3d rotated(const Pose& pose, const Vector3d& v) {
  return {(pose(0, 0) * v.x() + pose(0, 1) * v.y()) + pose(0, 2) * v.z(),
          (pose(1, 0) * v.x() + pose(1, 1) * v.y()) + pose(1, 2) * v.z(),
          (pose(2, 0) * v.x() + pose(2, 1) * v.y()) + pose(2, 2) * v.z()};
}

/// The inverse of the rotation part applied to a vector.
inline Vector3d rotated_back(const Pose& pose, const Vector3d& v) {
  return {(pose(0, 0) * v.x() + pose(1, 0) * v.y()) + pose(2, 0) * v.z(),
          (pose(0, 1) * v.x() + pose(1, 1) * v.y()) + pose(2, 1) * v.z(),
          (pose(0, 2) * v.x() + pose(1, 2) * v.y()) + pose(2, 2) * v.z()};
}

inline Vector3d translation(const Pose& pose) { return {pose(0, 3), pose(1, 3), pose(2, 3)}; }

inline Vector3d transformed(const Pose& pose, const Vector3d& point) {
  return rotated(pose, point) + translation(pose);
}

/// a * b: b first, then a.
Pose chained(const Pose& a, const Pose& b);

/// The pose at `position` whose axes in the outer frame are x, y and z.
Pose pose_of_axes(const Vector3d& position, const Vector3d& x, const Vector3d& y,
                  const Vector3d& z);

/// The pose at `position` turned by `yaw` about z, then `pitch` about the new y,
/// then `roll` about the new x; degrees.
Pose pose_of_angles(const Vector3d& position, double yaw, double pitch = 0, double roll = 0);

struct SineCosine {
  double sine;
  double cosine;
};

/// Of an angle in whole turns, exact to about 2e-16: 0.25 gives (1, 0).
SineCosine sine_cosine_of_turns(double turns);

inline SineCosine sine_cosine_of_degrees(double degrees) {
  return sine_cosine_of_turns(degrees / 360);
}

/// Natural logarithm of x > 0, relative error about 1e-15.
double natural_log(double x);

}  // namespace rmap::simulation
