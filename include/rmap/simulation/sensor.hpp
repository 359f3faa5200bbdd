#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <rmap/pose.hpp>
#include <rmap/scan.hpp>
#include <rmap/simulation/scene.hpp>

namespace rmap {

/// A lidar that turns about its z axis; its frame is x forward, y left, z up.
/// Beams are ordered by azimuth, counterclockwise from x, then upwards by channel.
struct SpinningLidar {
  int channels = 32;           ///< beams above one another, evenly spread over the elevations
  double min_elevation = -25;  ///< degrees above the xy plane; with one channel, its elevation
  double max_elevation = 15;   ///< degrees
  int azimuth_steps = 1024;    ///< beams a turn and channel
  double min_range = 0.5;      ///< metres along the beam; nearer surfaces give no return
  double max_range = 100;      ///< metres along the beam
};

/// A lidar with a limited field of view that two turning prisms scan in a
/// rosette; its frame is x forward, y left, z up. The rosette goes on from scan
/// to scan and never repeats, so that scans from one place fill in each other's
/// gaps.
struct SolidStateLidar {
  int beams = 10000;           ///< of one scan
  double horizontal_fov = 80;  ///< degrees, whole angle
  double vertical_fov = 60;    ///< degrees, whole angle
  double min_range = 0.3;      ///< metres along the beam; nearer surfaces give no return
  double max_range = 60;       ///< metres along the beam
};

/// A pinhole camera that measures depth; its frame is z forward, x right, y
/// down. One beam through the centre of each pixel, ordered by rows from the
/// upper left; pixel (u, v) looks along ((u - cx) / fx, (v - cy) / fy, 1).
struct DepthCamera {
  int width = 320;         ///< pixels
  int height = 240;        ///< pixels
  double fx = 280;         ///< focal length in pixel widths
  double fy = 280;         ///< focal length in pixel heights
  double cx = 159.5;       ///< column of the optical axis
  double cy = 119.5;       ///< row of the optical axis
  double min_range = 0.3;  ///< metres along the beam; nearer surfaces give no return
  double max_range = 8;    ///< metres along the beam
  double depth_noise = 0;  ///< standard deviation of the depth at 1 m; grows with depth squared
};

using SensorModel = std::variant<SpinningLidar, SolidStateLidar, DepthCamera>;

/// A sensor with its errors. All is deterministic: chance depends on nothing but
/// the seed and the indices of scan and beam.
struct Sensor {
  SensorModel model = SpinningLidar{};
  /// Standard deviation (m) of a normal error along the beam; the noisy range is
  /// kept within the sensor's limits.
  double noise = 0;
  /// Share of the returns that get lost, 0 to 1. Nothing is reported for them,
  /// since a beam that ended in a surface must not clear it.
  double dropped = 0;
  /// Whether beams that meet nothing within max_range go into Scan::no_returns,
  /// or are left out.
  bool no_returns = true;
  std::uint64_t seed = 0;
};

/// Names of the sensors that make_sensor knows, in a fixed order.
std::vector<std::string> sensor_names();

/// A sensor by name: `lidar16`, `lidar32`, `lidar64` (spinning, for outdoors),
/// `wide_lidar` (spinning, +-45 degrees, for indoors), `solid_state`, `depth_camera`.
/// Throws Error(input) that lists the names when there is no such sensor.
SensorModel make_sensor(std::string_view name);

/// Throws Error(input) that names the first field which is out of its range.
void check_sensor(const Sensor& sensor);

/// How a sensor sits on a robot, whose frame is x forward, y left, z up: lidars
/// share its axes, a camera looks along x.
Pose body_from_sensor(const SensorModel& model);

/// Directions of the beams of one scan in the sensor's frame, length 1. Only the
/// solid-state lidar's depend on `scan_index`.
std::vector<Vector3d> beam_directions(const SensorModel& model, std::uint64_t scan_index);

/// What the sensor sees of the scene, as it is at `time` (s), from a pose. The
/// points are in the sensor's frame, in the order of the beams; without noise,
/// the true hits rounded to float32 (within 2^-24 of the range: 3e-6 m at 50 m).
/// `sensor_range` is the model's max_range; the name is the scene's and the index.
/// Throws Error(input) by check_sensor and check_pose. Cost: one Scene::first_hit
/// a beam.
Scan simulate_scan(const Scene& scene, const Sensor& sensor, const Pose& map_from_sensor,
                   double time, std::uint64_t scan_index);

}  // namespace rmap
