#include "simulation/exact_math.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <rmap/error.hpp>
#include <rmap/simulation/sensor.hpp>

namespace rmap {

namespace {

// Bounds the memory of one scan.
constexpr double kMaxBeams = 1 << 24;

struct NamedSensor {
  const char* name;
  SensorModel model;
};

constexpr std::array<NamedSensor, 6> kSensors = {{
    {"lidar16", SpinningLidar{.channels = 16,
                              .min_elevation = -15,
                              .max_elevation = 15,
                              .azimuth_steps = 1800,
                              .min_range = 0.5,
                              .max_range = 100}},
    {"lidar32", SpinningLidar{.channels = 32,
                              .min_elevation = -25,
                              .max_elevation = 15,
                              .azimuth_steps = 1024,
                              .min_range = 0.5,
                              .max_range = 100}},
    {"lidar64", SpinningLidar{.channels = 64,
                              .min_elevation = -24.8,
                              .max_elevation = 2,
                              .azimuth_steps = 1800,
                              .min_range = 0.9,
                              .max_range = 120}},
    {"wide_lidar", SpinningLidar{.channels = 64,
                                 .min_elevation = -45,
                                 .max_elevation = 45,
                                 .azimuth_steps = 512,
                                 .min_range = 0.3,
                                 .max_range = 50}},
    {"solid_state", SolidStateLidar{}},
    {"depth_camera", DepthCamera{}},
}};

// Compares so that NaN is refused.
void check_between(const char* sensor, const char* field, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw Error(ErrorKind::input, fmt::format("the {}'s {} is {}: it must lie in {} to {}", sensor,
                                            field, value, low, high));
}

void check_positive(const char* sensor, const char* field, double value) {
  if (value > 0 && std::isfinite(value)) return;
  throw Error(ErrorKind::input, fmt::format("the {}'s {} is {}: it must be positive and finite",
                                            sensor, field, value));
}

void check_beams(const char* sensor, const char* fields, double beams) {
  if (beams <= kMaxBeams) return;
  throw Error(ErrorKind::input, fmt::format("the {}'s {} make {} beams a scan: at most {} are "
                                            "allowed",
                                            sensor, fields, beams, kMaxBeams));
}

void check_ranges(const char* sensor, double min_range, double max_range) {
  if (!(min_range >= 0 && std::isfinite(min_range))) {
    throw Error(ErrorKind::input,
                fmt::format("the {}'s min_range is {} m: it must be at least 0 and finite", sensor,
                            min_range));
  }
  if (!(max_range > min_range && std::isfinite(max_range))) {
    throw Error(ErrorKind::input,
                fmt::format("the {}'s max_range is {} m: it must be finite and beyond min_range, "
                            "{} m",
                            sensor, max_range, min_range));
  }
}

void check_model(const SpinningLidar& lidar) {
  constexpr char kName[] = "spinning lidar";
  check_between(kName, "channels", lidar.channels, 1, kMaxBeams);
  check_between(kName, "azimuth_steps", lidar.azimuth_steps, 1, kMaxBeams);
  check_beams(kName, "channels and azimuth_steps",
              static_cast<double>(lidar.channels) * lidar.azimuth_steps);
  check_between(kName, "min_elevation", lidar.min_elevation, -90, 90);
  check_between(kName, "max_elevation", lidar.max_elevation, lidar.min_elevation, 90);
  check_ranges(kName, lidar.min_range, lidar.max_range);
}

void check_model(const SolidStateLidar& lidar) {
  constexpr char kName[] = "solid-state lidar";
  check_between(kName, "beams", lidar.beams, 1, kMaxBeams);
  check_positive(kName, "horizontal_fov", lidar.horizontal_fov);
  check_between(kName, "horizontal_fov", lidar.horizontal_fov, 0, 360);
  check_positive(kName, "vertical_fov", lidar.vertical_fov);
  check_between(kName, "vertical_fov", lidar.vertical_fov, 0, 180);
  check_ranges(kName, lidar.min_range, lidar.max_range);
}

void check_model(const DepthCamera& camera) {
  constexpr char kName[] = "depth camera";
  check_between(kName, "width", camera.width, 1, kMaxBeams);
  check_between(kName, "height", camera.height, 1, kMaxBeams);
  check_beams(kName, "width and height", static_cast<double>(camera.width) * camera.height);
  check_positive(kName, "fx", camera.fx);
  check_positive(kName, "fy", camera.fy);
  check_between(kName, "cx", camera.cx, -kMaxBeams, kMaxBeams);
  check_between(kName, "cy", camera.cy, -kMaxBeams, kMaxBeams);
  check_between(kName, "depth_noise", camera.depth_noise, 0, 1);
  check_ranges(kName, camera.min_range, camera.max_range);
}

}  // namespace

std::vector<std::string> sensor_names() {
  std::vector<std::string> names;
  names.reserve(kSensors.size());
  for (const NamedSensor& sensor : kSensors) names.emplace_back(sensor.name);
  return names;
}

SensorModel make_sensor(std::string_view name) {
  for (const NamedSensor& sensor : kSensors) {
    if (sensor.name == name) return sensor.model;
  }
  throw Error(ErrorKind::input, fmt::format("there is no sensor '{}': the sensors are {}", name,
                                            fmt::join(sensor_names(), ", ")));
}

void check_sensor(const Sensor& sensor) {
  std::visit([](const auto& model) { check_model(model); }, sensor.model);
  check_between("sensor", "noise", sensor.noise, 0, 1000);
  check_between("sensor", "dropped", sensor.dropped, 0, 1);
}

Pose body_from_sensor(const SensorModel& model) {
  if (!std::holds_alternative<DepthCamera>(model)) return Pose::Identity();
  return simulation::pose_of_axes(Vector3d::Zero(), -Vector3d::UnitY(), -Vector3d::UnitZ(),
                                  Vector3d::UnitX());
}

}  // namespace rmap
