#pragma once

#include <array>
#include <string>
#include <string_view>

#include <Eigen/Geometry>

#include <rmap/cuboids.hpp>

namespace rmap {

/// Corner `index`, 0 to 7, of a box of metres or of cells: its bit a tells whether it is at max of
/// axis a.
template <class AnyBox>
auto corner_of(const AnyBox& box, unsigned index) {
  auto corner = box.min;
  for (int axis = 0; axis < 3; ++axis) {
    if ((index >> axis & 1U) != 0) corner[axis] = box.max[axis];
  }
  return corner;
}

/// Cuboids as boxes in the input's frame, metres. All of them are turned alike.
class InputBoxes {
 public:
  explicit InputBoxes(const CuboidList& list);

  Vector3d center(const CellBox& cells) const;
  /// Edge lengths, along the axes of the cells.
  Vector3d size(const CellBox& cells) const;
  /// As corner_of the cells.
  Vector3d corner(const CellBox& cells, unsigned index) const;
  /// A direction of the cells' frame.
  Vector3d direction(const Vector3d& along_cells) const { return rotation_ * along_cells; }

  /// From the axes of the cells to those of the input.
  const Eigen::Quaterniond& rotation() const { return rotation_; }
  /// The same as turns about the fixed axes x, y and z, in this order.
  Vector3d roll_pitch_yaw() const;

 private:
  Vector3d placed(const Vector3d& in_cells_frame) const {
    return rotation_ * in_cells_frame + translation_;
  }

  Lattice lattice_;
  Eigen::Quaterniond rotation_;
  Vector3d translation_;
};

/// The rotation of a pose as a unit quaternion with w >= 0.
Eigen::Quaterniond rotation_of(const Pose& pose);

/// Triangles of a box over the corners of InputBoxes, counter-clockwise seen from outside: two
/// for each side, the sides at min and max of x, then y, then z.
extern const std::array<std::array<unsigned, 3>, 12> kBoxTriangles;

/// Numbers as text, each with as many digits as give the same double back; no negative zero.
std::string joined(const Eigen::Ref<const Eigen::VectorXd>& numbers, std::string_view separator);

}  // namespace rmap
