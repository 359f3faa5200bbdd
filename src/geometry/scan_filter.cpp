#include <algorithm>

#include <rmap/scan_filter.hpp>

namespace rmap {

void ScanFilter::apply(Scan& scan, Counts& counts) const {
  if (ignore.empty() && !crop) return;
  const Pose sensor_from_map = scan.map_from_sensor.inverse();
  const auto in_sensor = [&](const Vector3f& point) -> Vector3d {
    return scan.frame == Frame::sensor ? point.cast<double>() : transformed(sensor_from_map, point);
  };
  const auto in_map = [&](const Vector3f& point) -> Vector3d {
    return scan.frame == Frame::map ? point.cast<double>()
                                    : transformed(scan.map_from_sensor, point);
  };
  const auto wanted = [&](const Vector3f& point) {
    if (!point.allFinite()) return true;
    const Vector3d sensor_point = in_sensor(point);
    if (std::any_of(ignore.begin(), ignore.end(),
                    [&](const Box& box) { return box.contains(sensor_point); })) {
      ++counts.ignored;
      return false;
    }
    if (crop && !crop->contains(in_map(point))) {
      ++counts.cropped;
      return false;
    }
    return true;
  };

  std::size_t kept = 0;
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    if (!wanted(scan.points[i])) continue;
    scan.points[kept] = scan.points[i];
    if (!scan.origins.empty()) scan.origins[kept] = scan.origins[i];
    ++kept;
  }
  scan.points.resize(kept);
  if (!scan.origins.empty()) scan.origins.resize(kept);
}

}  // namespace rmap
