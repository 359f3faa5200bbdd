#pragma once

#include <variant>

#include <rmap/box.hpp>

namespace rmap {

/// The outside of a box with edges `size` (m), centred in its own frame.
struct CuboidShape {
  Vector3d size = Vector3d::Ones();
};

/// A sphere around the origin of its own frame; metres.
struct SphereShape {
  double radius = 1;
};

/// A closed cylinder around the z axis of its own frame, from z = 0 to `height`; metres.
struct CylinderShape {
  double radius = 1;
  double height = 1;
};

/// A rectangle in the plane z = 0 of its own frame, centred, edges in metres:
/// the ground. It faces +z, and what lies below it counts as solid.
struct RectangleShape {
  double size_x = 1;
  double size_y = 1;
};

/// A surface with closed forms for what a simulation needs: where a ray meets it
/// and how far a point is from it.
using Shape = std::variant<CuboidShape, SphereShape, CylinderShape, RectangleShape>;

}  // namespace rmap
