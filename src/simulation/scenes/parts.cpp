#include "simulation/scenes/parts.hpp"

#include "simulation/exact_math.hpp"

#include <utility>

namespace rmap::simulation {

namespace {

SceneObject shape_at(std::string name, const Shape& shape, const Vector3d& position) {
  return {.name = std::move(name), .shape = shape, .map_from_object = pose_of_angles(position, 0)};
}

}  // namespace

SceneObject box_between(std::string name, const Vector3d& min, const Vector3d& max,
                        Side seen_from) {
  SceneObject object = shape_at(std::move(name), CuboidShape{.size = max - min}, (min + max) / 2);
  object.seen_from = seen_from;
  return object;
}

void add_ground(Scene& scene, const Vector3d& min, const Vector3d& max) {
  const Vector3d size = max - min;
  scene.add(
      shape_at("ground", RectangleShape{.size_x = size.x(), .size_y = size.y()}, (min + max) / 2));
}

void add_pole(Scene& scene, const std::string& name, double x, double y, double height) {
  scene.add(shape_at(name, CylinderShape{.radius = 0.08, .height = height}, {x, y, 0}));
}

void add_tree(Scene& scene, const std::string& name, double x, double y, double height,
              double crown_radius) {
  scene.add(shape_at(name + " trunk", CylinderShape{.radius = 0.2, .height = height}, {x, y, 0}));
  scene.add(shape_at(name + " crown", SphereShape{.radius = crown_radius}, {x, y, height}));
}

void add_car(Scene& scene, const std::string& name, double x, double y) {
  scene.add(box_between(name + " body", {x - 2.1, y - 0.9, 0.25}, {x + 2.1, y + 0.9, 0.95}));
  scene.add(box_between(name + " cabin", {x - 1.2, y - 0.8, 0.95}, {x + 1.0, y + 0.8, 1.5}));
}

}  // namespace rmap::simulation
