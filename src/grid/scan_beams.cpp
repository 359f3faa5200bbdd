#include "grid/scan_beams.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

double length_of(const Vector3d& vector) {
  return std::sqrt((vector.x() * vector.x() + vector.y() * vector.y()) + vector.z() * vector.z());
}

// Prepends the scan's name to what is wrong with it.
std::string about(const Scan& scan, const std::string& sentence) {
  return scan.name.empty() ? sentence : scan.name + ": " + sentence;
}

void check_scan(const Scan& scan, const Lattice& lattice) {
  try {
    check_pose(scan.map_from_sensor);
  } catch (const Error& error) {
    throw Error(error.kind(), about(scan, error.what()));
  }
  if (!scan.origins.empty() && scan.frame != Frame::map) {
    throw Error(ErrorKind::input,
                about(scan,
                      "the scan has an origin for each point, but its points are in the "
                      "sensor's frame: they must be in the map's"));
  }
  if (!scan.origins.empty() && scan.origins.size() != scan.points.size()) {
    throw Error(ErrorKind::input,
                about(scan, fmt::format("the scan has {} origins for {} points: it must have one "
                                        "for each point, or none",
                                        scan.origins.size(), scan.points.size())));
  }
  if (std::isnan(scan.sensor_range) || scan.sensor_range < 0) {
    throw Error(ErrorKind::input,
                about(scan, fmt::format("sensor_range is {} m: it must not be negative",
                                        scan.sensor_range)));
  }
  const auto check_origin = [&](const Vector3d& origin) {
    if (lattice.find_cell(origin)) return;
    throw Error(
        ErrorKind::limit,
        about(scan, fmt::format("the origin ({}, {}, {}) m is beyond what a map can hold: "
                                "at a resolution of {} m coordinates must lie within +-{:.15g} m",
                                origin.x(), origin.y(), origin.z(), lattice.resolution(),
                                kMaxCellIndex * lattice.resolution())));
  };
  check_origin(scan.map_from_sensor.translation());
  for (const Vector3d& origin : scan.origins) check_origin(origin);
}

}  // namespace

ScanBeams::ScanBeams(const Scan& scan, const Lattice& lattice, const Options& options)
    : scan_(scan),
      lattice_(lattice),
      options_(options),
      center_(scan.map_from_sensor.translation()) {
  check_scan(scan, lattice);
}

SortedPoint ScanBeams::sorted(std::size_t i) const {
  return i < point_count() ? sorted_point(scan_.points[i], origin(i))
                           : sorted_direction(scan_.no_returns[i - point_count()], center_);
}

std::optional<Beam> ScanBeams::beam(std::size_t i) const {
  const SortedPoint point = sorted(i);
  if (point.fate == SortedPoint::Fate::skipped) return std::nullopt;
  return Beam(point.origin, point.end, point.fate == SortedPoint::Fate::cut);
}

SortedPoint ScanBeams::sorted_point(const Vector3f& point, const Vector3d& origin) const {
  if (!point.allFinite()) return skipped(&SkippedPoints::not_finite, point, "is not finite");
  const Vector3d end = scan_.frame == Frame::sensor ? transformed(scan_.map_from_sensor, point)
                                                    : Vector3d(point.cast<double>());
  const Vector3d along = end - origin;
  const double length = length_of(along);
  if (length < options_.min_range) {
    return {.fate = SortedPoint::Fate::skipped, .reason = &SkippedPoints::too_near};
  }
  if (length > options_.max_range) return cut(point, origin, along, length, options_.max_range);
  if (!lattice_.find_cell(end)) {
    return skipped(&SkippedPoints::beyond_limits, point, "is beyond the limits of the map");
  }
  return {.fate = SortedPoint::Fate::ends,
          .origin = lattice_.to_cells(origin),
          .end = lattice_.to_cells(end)};
}

SortedPoint ScanBeams::sorted_direction(const Vector3f& direction, const Vector3d& origin) const {
  if (!direction.allFinite() || direction.isZero(0)) {
    return skipped(&SkippedPoints::not_finite, direction, "is no direction");
  }
  const double range = std::min(options_.max_range, scan_.sensor_range);
  if (!std::isfinite(range)) {
    return {.fate = SortedPoint::Fate::skipped, .reason = &SkippedPoints::no_range};
  }
  const Vector3d along = scan_.frame == Frame::sensor ? rotated(scan_.map_from_sensor, direction)
                                                      : Vector3d(direction.cast<double>());
  return cut(direction, origin, along, length_of(along), range);
}

SortedPoint ScanBeams::cut(const Vector3f& point, const Vector3d& origin, const Vector3d& along,
                           double length, double range) const {
  const Vector3d end = origin + along * (range / length);
  if (!lattice_.find_cell(end)) {
    return skipped(&SkippedPoints::beyond_limits, point, "is cut beyond the limits of the map");
  }
  return {.fate = SortedPoint::Fate::cut,
          .origin = lattice_.to_cells(origin),
          .end = lattice_.to_cells(end)};
}

SortedPoint ScanBeams::skipped(std::uint64_t SkippedPoints::*reason, const Vector3f& point,
                               const char* what) const {
  if (options_.bad_points == BadPoints::skip) {
    return {.fate = SortedPoint::Fate::skipped, .reason = reason};
  }
  std::string sentence =
      fmt::format("the point ({}, {}, {}) m {}", point.x(), point.y(), point.z(), what);
  if (reason == &SkippedPoints::beyond_limits) {
    sentence +=
        fmt::format(": at a resolution of {} m coordinates in the map must lie within +-{:.15g} m",
                    lattice_.resolution(), kMaxCellIndex * lattice_.resolution());
  }
  throw Error(ErrorKind::limit, about(scan_, sentence));
}

}  // namespace rmap
