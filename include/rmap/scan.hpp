#pragma once

#include <limits>
#include <string>
#include <vector>

#include <rmap/pose.hpp>

namespace rmap {

/// The frame that the points of a scan are given in.
enum class Frame {
  sensor,  ///< `map_from_sensor` carries them into the map
  map,     ///< they are in the map already and enter untransformed
};

/// What a range sensor saw from one pose.
struct Scan {
  /// Sensor's frame to the map's; its translation is the origin of the beams.
  Pose map_from_sensor = Pose::Identity();
  Frame frame = Frame::sensor;
  /// Ends of the beams, metres, in `frame`. Points that are not finite are skipped and counted.
  std::vector<Vector3f> points = {};
  /// With frame map, where each beam started (metres, map's frame), one for each
  /// point: a lidar that moved during the scan. Empty: all at the pose's translation.
  std::vector<Vector3d> origins = {};
  /// Directions in which nothing came back, in `frame`, of any length but zero:
  /// beams from the pose's translation that only clear, out to the smaller of
  /// `sensor_range` and the grid's `max_range`.
  std::vector<Vector3f> no_returns = {};
  /// How far the sensor sees, metres.
  double sensor_range = std::numeric_limits<double>::infinity();
  /// Where the scan came from, for messages: a file's name, say.
  std::string name = {};
};

}  // namespace rmap
