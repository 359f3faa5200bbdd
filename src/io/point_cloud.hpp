#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rmap/pose.hpp>

namespace rmap {

/// What a reader of points needs to know beside the file.
struct PointReadOptions {
  /// Whether the points are in the map's frame, as far as the caller knows. Points with an
  /// origin each are in any case.
  bool in_map = false;
  /// Taken off points in the map's frame, and off origins.
  Vector3d offset = Vector3d::Zero();
  /// Of `.bin` files, as in ScanReadOptions.
  std::vector<std::string> columns = {};
};

/// The points of a file before they become a scan.
struct PointCloud {
  std::vector<Vector3f> points;   ///< metres
  std::vector<Vector3d> origins;  ///< where the beam of each point began, or empty
  /// Sensor's frame to the map's, where the file says it.
  std::optional<Pose> map_from_sensor;
  /// Whether the file stores coordinates as float32: then they may have lost digits.
  bool stored_as_floats = false;
  /// Whether the reader has taken the offset off the points.
  bool shifted = false;

  /// Empties it for the next file, keeping its memory.
  void clear() {
    points.clear();
    origins.clear();
    map_from_sensor.reset();
    stored_as_floats = false;
    shifted = false;
  }
};

}  // namespace rmap
