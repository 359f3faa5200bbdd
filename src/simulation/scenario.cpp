#include "simulation/exact_math.hpp"
#include "simulation/scenes/builders.hpp"

#include <array>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <rmap/error.hpp>
#include <rmap/simulation/scenario.hpp>

namespace rmap {

namespace {

constexpr int kMaxScans = 1'000'000;
// Keeps surfaces on whole centimetres off the borders of cells.
constexpr double kOffBorders = 0.0033;

// The scenario carried elsewhere as a whole.
Scenario transformed(const Scenario& scenario, const Pose& new_from_old, const std::string& name) {
  Scenario moved = scenario;
  moved.scene = scenario.scene.transformed(new_from_old, name);
  for (TimedPose& pose : moved.trajectory) {
    pose.map_from_body = simulation::chained(new_from_old, pose.map_from_body);
  }
  return moved;
}

struct Tilt {
  double yaw;  // degrees
  double pitch;
  double roll;
};

struct SceneEntry {
  const char* name;
  Scenario (*build)(int scans);
  std::optional<Tilt> tilt = {};
};

Scenario tilted(const Scenario& scenario, const Tilt& tilt) {
  const Pose turn = simulation::pose_of_angles(Vector3d::Zero(), tilt.yaw, tilt.pitch, tilt.roll);
  Scenario turned = transformed(scenario, turn, scenario.scene.name());
  turned.description +=
      fmt::format(", turned about the origin by yaw {}, pitch {} and roll {} degrees", tilt.yaw,
                  tilt.pitch, tilt.roll);
  return turned;
}

constexpr std::array<SceneEntry, 9> kScenes = {{
    {"box", simulation::build_box},
    {"sphere", simulation::build_sphere},
    {"room", simulation::build_room},
    {"noisy_room", simulation::build_noisy_room},
    {"tilted_room", simulation::build_room, Tilt{.yaw = 30, .pitch = 8, .roll = -5}},
    {"stairs", simulation::build_stairs},
    {"street", simulation::build_street},
    {"campus", simulation::build_campus},
    {"moving", simulation::build_moving},
}};

}  // namespace

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  names.reserve(kScenes.size());
  for (const SceneEntry& scene : kScenes) names.emplace_back(scene.name);
  return names;
}

Scenario make_scene(std::string_view name, const ScenarioOptions& options) {
  if (options.scans < 0 || options.scans > kMaxScans) {
    throw Error(ErrorKind::input,
                fmt::format("scans is {}: it must lie in 1 to {}, or be 0 for the scene's own",
                            options.scans, kMaxScans));
  }
  for (const SceneEntry& scene : kScenes) {
    if (scene.name != name) continue;
    const Pose shift = simulation::pose_of_angles(Vector3d::Constant(kOffBorders), 0);
    Scenario scenario = transformed(scene.build(options.scans), shift, scene.name);
    return scene.tilt ? tilted(scenario, *scene.tilt) : scenario;
  }
  throw Error(ErrorKind::input, fmt::format("there is no scene '{}': the scenes are {}", name,
                                            fmt::join(scene_names(), ", ")));
}

}  // namespace rmap
