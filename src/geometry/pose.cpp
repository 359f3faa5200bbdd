#include <cmath>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/pose.hpp>

namespace rmap {

namespace {

constexpr double kRotationTolerance = 1e-3;

// Written out: Eigen's products may contract or reorder.
double row_times(const Pose& pose, int row, double x, double y, double z) {
  return (pose(row, 0) * x + pose(row, 1) * y) + pose(row, 2) * z;
}

}  // namespace

void check_pose(const Pose& pose) {
  if (!pose.matrix().topRows<3>().allFinite()) {
    throw Error(ErrorKind::input, "the pose holds a number that is not finite");
  }
  const Eigen::Matrix3d rotation = pose.linear();
  const double deviation =
      (rotation.transpose() * rotation - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(deviation <= kRotationTolerance)) {
    throw Error(ErrorKind::input,
                fmt::format("the 3x3 part of the pose is no rotation: it is {} away from "
                            "orthonormal, {} is allowed",
                            deviation, kRotationTolerance));
  }
  if (rotation.determinant() < 0) {
    throw Error(ErrorKind::input,
                "the 3x3 part of the pose is no rotation but a reflection: its determinant is -1");
  }
}

Pose make_pose(const Vector3d& translation, const Eigen::Quaterniond& rotation) {
  if (!translation.allFinite() || !rotation.coeffs().allFinite()) {
    throw Error(ErrorKind::input, "the pose holds a number that is not finite");
  }
  // Scaled first, so that the norm of tiny or huge quaternions neither vanishes nor overflows.
  const double largest = rotation.coeffs().cwiseAbs().maxCoeff();
  if (largest == 0) {
    throw Error(ErrorKind::input, "the quaternion of the pose is zero: it must have a length");
  }
  const Eigen::Vector4d scaled = rotation.coeffs() / largest;
  // Summed by hand: Eigen's order depends on the width of the machine's registers.
  const double norm =
      std::sqrt(((scaled[0] * scaled[0] + scaled[1] * scaled[1]) + scaled[2] * scaled[2]) +
                scaled[3] * scaled[3]);
  Pose pose = Pose::Identity();
  pose.linear() = Eigen::Quaterniond(Eigen::Vector4d(scaled / norm)).toRotationMatrix();
  pose.translation() = translation;
  return pose;
}

Vector3d rotated(const Pose& map_from_sensor, const Vector3f& direction) {
  const double x = direction.x();
  const double y = direction.y();
  const double z = direction.z();
  return {row_times(map_from_sensor, 0, x, y, z), row_times(map_from_sensor, 1, x, y, z),
          row_times(map_from_sensor, 2, x, y, z)};
}

Vector3d transformed(const Pose& map_from_sensor, const Vector3f& point) {
  const Vector3d turned = rotated(map_from_sensor, point);
  return {turned.x() + map_from_sensor(0, 3), turned.y() + map_from_sensor(1, 3),
          turned.z() + map_from_sensor(2, 3)};
}

}  // namespace rmap
