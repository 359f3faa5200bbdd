#include "truth.hpp"

#include "words.hpp"

#include <cmath>

namespace rmap::command {

namespace {

using command::json_of;  // beside the overloads below

Json json_of(const CuboidShape& shape) {
  return {{"type", "cuboid"}, {"size", json_of(shape.size)}};
}

Json json_of(const SphereShape& shape) { return {{"type", "sphere"}, {"radius", shape.radius}}; }

Json json_of(const CylinderShape& shape) {
  return {{"type", "cylinder"}, {"radius", shape.radius}, {"height", shape.height}};
}

Json json_of(const RectangleShape& shape) {
  return {{"type", "rectangle"}, {"size_x", shape.size_x}, {"size_y", shape.size_y}};
}

Json json_of(const SpinningLidar& lidar) {
  return {{"type", "spinning_lidar"},
          {"channels", lidar.channels},
          {"min_elevation", lidar.min_elevation},
          {"max_elevation", lidar.max_elevation},
          {"azimuth_steps", lidar.azimuth_steps},
          {"min_range", lidar.min_range},
          {"max_range", lidar.max_range}};
}

Json json_of(const SolidStateLidar& lidar) {
  return {{"type", "solid_state_lidar"},
          {"beams", lidar.beams},
          {"horizontal_fov", lidar.horizontal_fov},
          {"vertical_fov", lidar.vertical_fov},
          {"min_range", lidar.min_range},
          {"max_range", lidar.max_range}};
}

Json json_of(const DepthCamera& camera) {
  return {{"type", "depth_camera"},
          {"width", camera.width},
          {"height", camera.height},
          {"fx", camera.fx},
          {"fy", camera.fy},
          {"cx", camera.cx},
          {"cy", camera.cy},
          {"min_range", camera.min_range},
          {"max_range", camera.max_range},
          {"depth_noise", camera.depth_noise}};
}

// The 3x4 matrix row by row, as in poses.txt.
Json json_of(const Pose& pose) {
  Json numbers = Json::array();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) numbers.push_back(pose(row, column));
  }
  return numbers;
}

Json json_of_time(double time) { return std::isfinite(time) ? Json(time) : Json(nullptr); }

Json json_of(const SceneObject& object) {
  Json motion = Json::array();
  for (const Waypoint& waypoint : object.motion) {
    motion.push_back({{"time", waypoint.time}, {"translation", json_of(waypoint.translation)}});
  }
  return {{"name", object.name},
          {"shape", std::visit([](const auto& shape) { return json_of(shape); }, object.shape)},
          {"map_from_object", json_of(object.map_from_object)},
          {"seen_from", word_of(object.seen_from)},
          {"static", is_static(object)},
          {"motion", motion},
          {"visible_from", json_of_time(object.visible_from)},
          {"visible_until", json_of_time(object.visible_until)}};
}

}  // namespace

Json truth_of(const Simulation& simulation) {
  const Sensor& sensor = simulation.sensor();
  Json times = Json::array();
  for (std::size_t i = 0; i < simulation.size(); ++i) times.push_back(simulation.time(i));
  Json objects = Json::array();
  for (const SceneObject& object : simulation.scene().objects()) objects.push_back(json_of(object));
  return {{"scene", simulation.name()},
          {"description", simulation.description()},
          {"sensor", std::visit([](const auto& model) { return json_of(model); }, sensor.model)},
          {"noise", sensor.noise},
          {"dropped", sensor.dropped},
          {"seed", sensor.seed},
          {"times", times},
          {"objects", objects}};
}

}  // namespace rmap::command
