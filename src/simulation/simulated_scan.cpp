#include "simulation/exact_math.hpp"
#include "simulation/random_stream.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <rmap/simulation/sensor.hpp>

namespace rmap {

namespace {

struct Limits {
  double min_range;
  double max_range;
};

Limits limits_of(const SensorModel& model) {
  return std::visit(
      [](const auto& sensor) {
        return Limits{.min_range = sensor.min_range, .max_range = sensor.max_range};
      },
      model);
}

// Standard deviation of the measured range of a surface at `range` along `direction`.
double range_noise(const Sensor& sensor, double range, const Vector3d& direction) {
  const auto* camera = std::get_if<DepthCamera>(&sensor.model);
  if (camera == nullptr || camera->depth_noise == 0) return sensor.noise;
  const double depth = range * direction.z();
  const double of_depth = camera->depth_noise * depth * depth / direction.z();
  return std::sqrt(sensor.noise * sensor.noise + of_depth * of_depth);
}

}  // namespace

Scan simulate_scan(const Scene& scene, const Sensor& sensor, const Pose& map_from_sensor,
                   double time, std::uint64_t scan_index) {
  check_sensor(sensor);
  check_pose(map_from_sensor);
  const Limits limits = limits_of(sensor.model);
  const Vector3d origin = simulation::translation(map_from_sensor);

  Scan scan;
  scan.map_from_sensor = map_from_sensor;
  scan.sensor_range = limits.max_range;
  scan.name = fmt::format("{}/{:06}", scene.name(), scan_index);
  const std::vector<Vector3d> directions = beam_directions(sensor.model, scan_index);
  for (std::size_t beam = 0; beam < directions.size(); ++beam) {
    const Vector3d& direction = directions[beam];
    const auto hit = scene.first_hit(origin, simulation::rotated(map_from_sensor, direction),
                                     limits.max_range, time);
    if (!hit) {
      if (sensor.no_returns) scan.no_returns.push_back(direction.cast<float>());
      continue;
    }
    if (hit->range < limits.min_range) continue;
    // Drawn in this order whatever the options, so that each error has its own chance.
    simulation::RandomStream random(sensor.seed, scan_index, beam);
    if (random.uniform() < sensor.dropped) continue;
    double range = hit->range;
    if (const double noise = range_noise(sensor, range, direction); noise > 0) {
      range = std::clamp(range + noise * random.gaussian(), limits.min_range, limits.max_range);
    }
    scan.points.push_back((direction * range).cast<float>());
  }
  return scan;
}

}  // namespace rmap
