#include "io/input_boxes.hpp"

#include <cmath>

#include <fmt/format.h>

namespace rmap {

const std::array<std::array<unsigned, 3>, 12> kBoxTriangles = {{
    {0, 4, 6},
    {0, 6, 2},
    {1, 3, 7},
    {1, 7, 5},
    {0, 1, 5},
    {0, 5, 4},
    {2, 6, 7},
    {2, 7, 3},
    {0, 2, 3},
    {0, 3, 1},
    {4, 5, 7},
    {4, 7, 6},
}};

Eigen::Quaterniond rotation_of(const Pose& pose) {
  Eigen::Quaterniond rotation = Eigen::Quaterniond(pose.linear()).normalized();
  if (rotation.w() < 0) rotation.coeffs() = -rotation.coeffs();
  return rotation;
}

InputBoxes::InputBoxes(const CuboidList& list)
    : lattice_(list.resolution),
      rotation_(rotation_of(list.frame).conjugate()),
      translation_(-(rotation_ * list.frame.translation())) {}

Vector3d InputBoxes::center(const CellBox& cells) const {
  const Box box = lattice_.metric(cells);
  return placed((box.min + box.max) / 2);
}

Vector3d InputBoxes::size(const CellBox& cells) const {
  return cells.extent().cast<double>() * lattice_.resolution();
}

Vector3d InputBoxes::corner(const CellBox& cells, unsigned index) const {
  return placed(corner_of(lattice_.metric(cells), index));
}

Vector3d InputBoxes::roll_pitch_yaw() const {
  const Eigen::Matrix3d turn = rotation_.toRotationMatrix();
  const double yaw = std::atan2(turn(1, 0), turn(0, 0));
  const double pitch = std::atan2(-turn(2, 0), std::hypot(turn(0, 0), turn(1, 0)));
  // From what is left after the yaw: sound where the pitch is a right angle, too.
  const double sine = std::sin(yaw);
  const double cosine = std::cos(yaw);
  const double roll =
      std::atan2(sine * turn(0, 2) - cosine * turn(1, 2), cosine * turn(1, 1) - sine * turn(0, 1));
  return {roll, pitch, yaw};
}

std::string joined(const Eigen::Ref<const Eigen::VectorXd>& numbers, std::string_view separator) {
  std::string text;
  for (const double number : numbers) {
    fmt::format_to(std::back_inserter(text), "{}{}", text.empty() ? "" : separator,
                   number == 0 ? 0.0 : number);
  }
  return text;
}

}  // namespace rmap
