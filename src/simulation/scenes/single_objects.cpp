#include "simulation/scenes/builders.hpp"
#include "simulation/scenes/parts.hpp"
#include "simulation/trajectory.hpp"

namespace rmap::simulation {

namespace {

Scenario seen_from_all_around(Scene scene, std::string description, int scans) {
  return {.description = std::move(description),
          .scene = std::move(scene),
          .trajectory = all_around(4, scans == 0 ? 24 : scans),
          .sensor = {.model = make_sensor("depth_camera")}};
}

}  // namespace

Scenario build_box(int scans) {
  Scene scene("box");
  scene.add(box_between("box", {-1, -0.6, -0.4}, {1, 0.6, 0.4}));
  return seen_from_all_around(
      std::move(scene), "one box of 2 x 1.2 x 0.8 m in empty space, seen from all around", scans);
}

Scenario build_sphere(int scans) {
  Scene scene("sphere");
  scene.add({.name = "sphere", .shape = SphereShape{.radius = 1}});
  return seen_from_all_around(
      std::move(scene), "one sphere of radius 1 m in empty space, seen from all around", scans);
}

}  // namespace rmap::simulation
