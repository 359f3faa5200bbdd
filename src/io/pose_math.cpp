#include "io/pose_math.hpp"

#include <array>
#include <cmath>

namespace rmap {

namespace {

using Quaternion = std::array<double, 4>;  // x, y, z, w

// Halved so often an arc is straight as far as a double can tell.
constexpr int kHalvings = 20;

double dot(const Quaternion& a, const Quaternion& b) {
  return ((a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]) + a[3] * b[3];
}

Quaternion mixed(const Quaternion& a, double share_of_a, const Quaternion& b, double share_of_b) {
  Quaternion mix{};
  for (std::size_t i = 0; i < mix.size(); ++i) mix[i] = share_of_a * a[i] + share_of_b * b[i];
  const double length = std::sqrt(dot(mix, mix));
  for (double& number : mix) number /= length;
  return mix;
}

Quaternion rotation_of(const Pose& pose) {
  const Eigen::Matrix3d rotation = pose.linear();
  const Eigen::Quaterniond quaternion(rotation);
  return mixed({quaternion.x(), quaternion.y(), quaternion.z(), quaternion.w()}, 1, {}, 0);
}

// Halves the arc around the place asked for, so that only sums and square roots are needed:
// what sines give is left open by the standard.
Quaternion turned(Quaternion before, Quaternion after, double share) {
  if (dot(before, after) < 0) {
    for (double& number : after) number = -number;
  }
  for (int i = 0; i < kHalvings; ++i) {
    const Quaternion middle = mixed(before, 1, after, 1);
    share *= 2;
    if (share < 1) {
      after = middle;
    } else {
      before = middle;
      share -= 1;
    }
  }
  return mixed(before, 1 - share, after, share);
}

double product(const Pose& a, int row, double x, double y, double z) {
  return (a(row, 0) * x + a(row, 1) * y) + a(row, 2) * z;
}

}  // namespace

Pose matrix_pose(const double* numbers) {
  Pose pose = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) pose(row, column) = *numbers++;
  }
  check_pose(pose);
  return pose;
}

Pose composed(const Pose& a_from_b, const Pose& b_from_c) {
  Pose result = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      result(row, column) =
          product(a_from_b, row, b_from_c(0, column), b_from_c(1, column), b_from_c(2, column));
    }
    result(row, 3) += a_from_b(row, 3);
  }
  return result;
}

Pose inverted(const Pose& a_from_b) {
  Pose result = Pose::Identity();
  result.linear() = a_from_b.linear().transpose();
  for (int row = 0; row < 3; ++row) {
    result(row, 3) = -product(result, row, a_from_b(0, 3), a_from_b(1, 3), a_from_b(2, 3));
  }
  return result;
}

Pose between(const Pose& before, const Pose& after, double share) {
  const Quaternion rotation = turned(rotation_of(before), rotation_of(after), share);
  Vector3d translation;
  for (int i = 0; i < 3; ++i) {
    translation[i] = before(i, 3) * (1 - share) + after(i, 3) * share;
  }
  return make_pose(translation,
                   Eigen::Quaterniond(rotation[3], rotation[0], rotation[1], rotation[2]));
}

}  // namespace rmap
