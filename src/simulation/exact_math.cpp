#include "simulation/exact_math.hpp"

#include <numbers>

namespace rmap::simulation {

Vector3d cross(const Vector3d& a, const Vector3d& b) {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

Pose chained(const Pose& a, const Pose& b) {
  const auto axis = [&](int column) {
    return rotated(a, {b(0, column), b(1, column), b(2, column)});
  };
  return pose_of_axes(transformed(a, translation(b)), axis(0), axis(1), axis(2));
}

Pose pose_of_axes(const Vector3d& position, const Vector3d& x, const Vector3d& y,
                  const Vector3d& z) {
  Pose pose = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    pose(row, 0) = x[row];
    pose(row, 1) = y[row];
    pose(row, 2) = z[row];
    pose(row, 3) = position[row];
  }
  return pose;
}

Pose pose_of_angles(const Vector3d& position, double yaw, double pitch, double roll) {
  const auto [sy, cy] = sine_cosine_of_degrees(yaw);
  const auto [sp, cp] = sine_cosine_of_degrees(pitch);
  const auto [sr, cr] = sine_cosine_of_degrees(roll);
  return pose_of_axes(position, {cy * cp, sy * cp, -sp},
                      {cy * sp * sr - sy * cr, sy * sp * sr + cy * cr, cp * sr},
                      {cy * sp * cr + sy * sr, sy * sp * cr - cy * sr, cp * cr});
}

SineCosine sine_cosine_of_turns(double turns) {
  // Both subtractions are exact, so that no angle is too large.
  const double within_turn = turns - std::round(turns);
  const double quarter = std::round(4 * within_turn);
  const double angle = (within_turn - quarter / 4) * (2 * std::numbers::pi);

  // Taylor series, |angle| <= pi / 4: the terms left out are below 2^-57.
  const double square = angle * angle;
  double sine = 0;
  double cosine = 0;
  for (int n = 16; n >= 2; n -= 2) {
    sine = (1 + sine) * (-square / (n * (n + 1)));
    cosine = (1 + cosine) * (-square / ((n - 1) * n));
  }
  sine = angle + angle * sine;
  cosine = 1 + cosine;

  switch (static_cast<int>(quarter)) {
    case 0:
      return {sine, cosine};
    case 1:
      return {cosine, -sine};
    case -1:
      return {-cosine, sine};
    default:
      return {-sine, -cosine};
  }
}

double natural_log(double x) {
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < std::numbers::sqrt2 / 2) {
    mantissa *= 2;
    --exponent;
  }
  // log m = 2 artanh((m - 1) / (m + 1)), a series in z^2 < 0.0295.
  const double z = (mantissa - 1) / (mantissa + 1);
  const double square = z * z;
  double series = 0;
  for (int n = 23; n >= 1; n -= 2) series = series * square + 1.0 / n;
  return exponent * std::numbers::ln2 + 2 * z * series;
}

}  // namespace rmap::simulation
