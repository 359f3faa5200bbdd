#include "simulation/exact_math.hpp"

#include <rmap/simulation/sensor.hpp>

namespace rmap {

namespace {

using simulation::SineCosine;

// Turns of the two prisms from beam to beam, as fractions of 2^64: they wrap
// around exactly, so that the rosette goes on for ever. 7294 and -4664 turns a
// minute at 100,000 beams a second; odd, so that the period is 2^64 beams.
constexpr std::uint64_t kFirstPrismStep = 22425091878939577u;
constexpr std::uint64_t kSecondPrismStep = std::uint64_t{0} - 14339269059963559u;

Vector3d direction_of(const SineCosine& azimuth, const SineCosine& elevation) {
  return {elevation.cosine * azimuth.cosine, elevation.cosine * azimuth.sine, elevation.sine};
}

SineCosine prism(std::uint64_t step, std::uint64_t beam) {
  return simulation::sine_cosine_of_turns(static_cast<double>((step * beam) >> 11) * 0x1p-53);
}

std::vector<Vector3d> directions(const SpinningLidar& lidar, std::uint64_t /*scan_index*/) {
  std::vector<SineCosine> elevations;
  for (int channel = 0; channel < lidar.channels; ++channel) {
    const double share =
        lidar.channels > 1 ? static_cast<double>(channel) / (lidar.channels - 1) : 0;
    elevations.push_back(simulation::sine_cosine_of_degrees(
        lidar.min_elevation + share * (lidar.max_elevation - lidar.min_elevation)));
  }
  std::vector<Vector3d> beams;
  beams.reserve(static_cast<std::size_t>(lidar.azimuth_steps) * elevations.size());
  for (int step = 0; step < lidar.azimuth_steps; ++step) {
    const SineCosine azimuth =
        simulation::sine_cosine_of_turns(static_cast<double>(step) / lidar.azimuth_steps);
    for (const SineCosine& elevation : elevations) {
      beams.push_back(direction_of(azimuth, elevation));
    }
  }
  return beams;
}

std::vector<Vector3d> directions(const SolidStateLidar& lidar, std::uint64_t scan_index) {
  const auto count = static_cast<std::uint64_t>(lidar.beams);
  std::vector<Vector3d> beams;
  beams.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::uint64_t beam = scan_index * count + i;
    const SineCosine first = prism(kFirstPrismStep, beam);
    const SineCosine second = prism(kSecondPrismStep, beam);
    const double azimuth = lidar.horizontal_fov / 4 * (first.cosine + second.cosine);
    const double elevation = lidar.vertical_fov / 4 * (first.sine + second.sine);
    beams.push_back(direction_of(simulation::sine_cosine_of_degrees(azimuth),
                                 simulation::sine_cosine_of_degrees(elevation)));
  }
  return beams;
}

std::vector<Vector3d> directions(const DepthCamera& camera, std::uint64_t /*scan_index*/) {
  std::vector<Vector3d> beams;
  beams.reserve(static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height));
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      beams.push_back(
          simulation::unit({(u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy, 1}));
    }
  }
  return beams;
}

}  // namespace

std::vector<Vector3d> beam_directions(const SensorModel& model, std::uint64_t scan_index) {
  return std::visit([&](const auto& sensor) { return directions(sensor, scan_index); }, model);
}

}  // namespace rmap
