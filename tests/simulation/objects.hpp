#pragma once

#include "simulation/exact_math.hpp"
#include "support/random.hpp"

#include <rmap/simulation/scene.hpp>

namespace rmap::test {

/// A pose that is turned at random, or stands straight.
inline Pose random_pose(Random& random, double reach) {
  const Vector3d position = random.point(-reach, reach);
  if (random.chance(0.3)) return simulation::pose_of_angles(position, 0);
  const Vector3d angles = random.point(-180, 180);
  return simulation::pose_of_angles(position, angles.x(), angles.y(), angles.z());
}

/// A shape of kind 0 to 3 with edges and radii of 0.1 to 3 m.
inline Shape random_shape(Random& random, int kind) {
  const Vector3d size = random.point(0.1, 3);
  if (kind == 0) return CuboidShape{.size = size};
  if (kind == 1) return SphereShape{.radius = size.x()};
  if (kind == 2) return CylinderShape{.radius = size.x(), .height = size.y()};
  return RectangleShape{.size_x = size.x(), .size_y = size.y()};
}

inline SceneObject random_object(Random& random, int kind, double reach) {
  return {.name = "object",
          .shape = random_shape(random, kind),
          .map_from_object = random_pose(random, reach),
          .seen_from = random.chance(0.2) ? Side::inside : Side::outside};
}

inline Scene scene_of(const SceneObject& object) {
  Scene scene("one");
  scene.add(object);
  return scene;
}

}  // namespace rmap::test
