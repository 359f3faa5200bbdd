#include "grid/sorted_scan.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

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
                about(scan, "the scan has an origin for each point, but its points are in the "
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
    throw Error(ErrorKind::limit,
                about(scan, fmt::format("the origin ({}, {}, {}) m is beyond what a map can hold: "
                                        "at a resolution of {} m coordinates must lie within +-{} m",
                                        origin.x(), origin.y(), origin.z(), lattice.resolution(),
                                        kMaxCellIndex * lattice.resolution())));
  };
  check_origin(scan.map_from_sensor.translation());
  for (const Vector3d& origin : scan.origins) check_origin(origin);
}

class Sorter {
 public:
  Sorter(const Scan& scan, const Lattice& lattice, const Options& options, Content content)
      : scan_(scan),
        lattice_(lattice),
        options_(options),
        wants_beams_(content == Content::end_cells_and_beams) {}

  SortedScan sort() {
    sorted_.points = scan_.points.size() + scan_.no_returns.size();
    sorted_.end_cells.reserve(scan_.points.size());
    if (wants_beams_) sorted_.beams.reserve(sorted_.points);
    const Vector3d center = scan_.map_from_sensor.translation();
    for (std::size_t i = 0; i < scan_.points.size(); ++i) {
      add_point(scan_.points[i], scan_.origins.empty() ? center : scan_.origins[i]);
    }
    for (const Vector3f& direction : scan_.no_returns) add_no_return(direction, center);
    return std::move(sorted_);
  }

 private:
  void add_point(const Vector3f& point, const Vector3d& origin) {
    if (!point.allFinite()) return skip(sorted_.skipped.not_finite, point, "is not finite");
    const Vector3d end = scan_.frame == Frame::sensor ? transformed(scan_.map_from_sensor, point)
                                                      : Vector3d(point.cast<double>());
    const Vector3d along = end - origin;
    const double length = length_of(along);
    if (length < options_.min_range) {
      ++sorted_.skipped.too_near;
    } else if (length > options_.max_range) {
      add_cut(point, origin, along, length, options_.max_range);
    } else if (const auto cell = lattice_.find_cell(end)) {
      sorted_.end_cells.push_back(*cell);
      add_beam(origin, end, false);
    } else {
      skip(sorted_.skipped.beyond_limits, point, "is beyond the limits of the map");
    }
  }

  void add_no_return(const Vector3f& direction, const Vector3d& origin) {
    if (!direction.allFinite() || direction.isZero(0)) {
      return skip(sorted_.skipped.not_finite, direction, "is no direction");
    }
    const double range = std::min(options_.max_range, scan_.sensor_range);
    if (!std::isfinite(range)) {
      ++sorted_.skipped.no_range;
      return;
    }
    const Vector3d along = scan_.frame == Frame::sensor ? rotated(scan_.map_from_sensor, direction)
                                                        : Vector3d(direction.cast<double>());
    add_cut(direction, origin, along, length_of(along), range);
  }

  void add_cut(const Vector3f& point, const Vector3d& origin, const Vector3d& along, double length,
               double range) {
    const Vector3d end = origin + along * (range / length);
    if (!lattice_.find_cell(end)) {
      return skip(sorted_.skipped.beyond_limits, point, "is cut beyond the limits of the map");
    }
    ++sorted_.cut;
    add_beam(origin, end, true);
  }

  void add_beam(const Vector3d& origin, const Vector3d& end, bool cut) {
    if (wants_beams_) {
      sorted_.beams.emplace_back(lattice_.to_cells(origin), lattice_.to_cells(end), cut);
    }
  }

  void skip(std::uint64_t& reason, const Vector3f& point, const char* what) const {
    ++reason;
    if (options_.bad_points == BadPoints::skip) return;
    throw Error(ErrorKind::limit,
                about(scan_, fmt::format("the point ({}, {}, {}) m {}: at a resolution of {} m "
                                         "coordinates in the map must lie within +-{} m",
                                         point.x(), point.y(), point.z(), what,
                                         lattice_.resolution(),
                                         kMaxCellIndex * lattice_.resolution())));
  }

  const Scan& scan_;
  const Lattice& lattice_;
  const Options& options_;
  bool wants_beams_;
  SortedScan sorted_;
};

auto coordinates(const Vector3d& point) { return std::make_tuple(point.x(), point.y(), point.z()); }

}  // namespace

SortedScan sorted(const Scan& scan, const Lattice& lattice, const Options& options,
                  Content content) {
  check_scan(scan, lattice);
  return Sorter(scan, lattice, options, content).sort();
}

void keep_one_beam_per_end_cell(std::vector<Beam>& beams) {
  struct Candidate {
    Cell cell;
    double distance;  // squared, from the cell's centre
    const Beam* beam;
  };
  std::vector<Candidate> candidates;
  std::vector<Beam> kept;
  for (const Beam& beam : beams) {
    if (beam.cut()) {
      kept.push_back(beam);
      continue;
    }
    const Cell cell = *cell_at(beam.end());
    const Vector3d off = beam.end() - (cell.cast<double>().array() + 0.5).matrix();
    const double distance = (off.x() * off.x() + off.y() * off.y()) + off.z() * off.z();
    candidates.push_back({cell, distance, &beam});
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    if (a.cell != b.cell) return morton_less(a.cell, b.cell);
    if (a.distance != b.distance) return a.distance < b.distance;
    return std::make_tuple(coordinates(a.beam->end()), coordinates(a.beam->origin())) <
           std::make_tuple(coordinates(b.beam->end()), coordinates(b.beam->origin()));
  });
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (i == 0 || candidates[i].cell != candidates[i - 1].cell) {
      kept.push_back(*candidates[i].beam);
    }
  }
  beams = std::move(kept);
}

}  // namespace rmap
