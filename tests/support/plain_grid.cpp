#include "support/plain_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include <fmt/format.h>

namespace rmap::test {

namespace {

using Triple = std::array<double, 3>;

int steps(double probability) {
  return static_cast<int>(std::lround(1000 * std::log(probability / (1 - probability))));
}

int step(double probability, double prior) {
  return static_cast<int>(std::lround(
      1000 * (std::log(probability / (1 - probability)) - std::log(prior / (1 - prior)))));
}

// The cells about a beam: none beyond can be crossed.
CellBox surroundings(const PlainBeam& beam) {
  CellBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<int>(axis);
    box.min[i] = static_cast<int>(std::floor(std::fmin(beam.origin[axis], beam.end[axis]))) - 1;
    box.max[i] = static_cast<int>(std::floor(std::fmax(beam.origin[axis], beam.end[axis]))) + 2;
  }
  return box;
}

bool in_limits(double index) { return index >= -0x1p30 && index <= 0x1p30 - 1; }

}  // namespace

struct PlainGrid::Sorted {
  std::vector<PlainBeam> beams;
  std::set<Cell, MortonOrder> ends;
  InsertReport report;
};

PlainGrid::Sorted PlainGrid::sort_out(const Scan& scan) const {
  Sorted sorted;
  const double inverse = 1 / options_.resolution;
  struct Candidate {
    double distance;
    Triple end, origin;
  };
  std::map<Cell, Candidate, MortonOrder> nearest;

  const auto world = [&](const Vector3f& point, bool translate) {
    Triple place{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<int>(axis);
      if (scan.frame == Frame::map) {
        place[axis] = point[i];
        continue;
      }
      const auto& pose = scan.map_from_sensor;
      double sum = pose(i, 0) * static_cast<double>(point.x());
      sum = sum + pose(i, 1) * static_cast<double>(point.y());
      sum = sum + pose(i, 2) * static_cast<double>(point.z());
      place[axis] = translate ? sum + pose(i, 3) : sum;
    }
    return place;
  };
  const auto add = [&](const Triple& origin, const Triple& end, bool cut) {
    PlainBeam beam{.origin = {}, .end = {}, .cut = cut};
    Cell cell;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      beam.origin[axis] = origin[axis] * inverse;
      beam.end[axis] = end[axis] * inverse;
      if (!in_limits(std::floor(beam.end[axis]))) {
        ++sorted.report.skipped.beyond_limits;
        return;
      }
      cell[static_cast<int>(axis)] = static_cast<int>(std::floor(beam.end[axis]));
    }
    if (cut) {
      ++sorted.report.cut;
      sorted.beams.push_back(beam);
      return;
    }
    ++sorted.report.inserted;
    if (follows(cell)) sorted.ends.insert(cell);
    if (options_.beams == Beams::all) {
      sorted.beams.push_back(beam);
      return;
    }
    double distance = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double off = beam.end[axis] - (cell[static_cast<int>(axis)] + 0.5);
      distance = distance + off * off;
    }
    const Candidate candidate{distance, beam.end, beam.origin};
    const auto key = [](const Candidate& c) { return std::tie(c.distance, c.end, c.origin); };
    const auto [place, is_new] = nearest.try_emplace(cell, candidate);
    if (!is_new && key(candidate) < key(place->second)) place->second = candidate;
  };

  const Vector3d center = scan.map_from_sensor.translation();
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Vector3f& point = scan.points[i];
    ++sorted.report.points;
    if (!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z())) {
      ++sorted.report.skipped.not_finite;
      continue;
    }
    const Vector3d start = scan.origins.empty() ? center : scan.origins[i];
    const Triple origin{start.x(), start.y(), start.z()};
    Triple end = world(point, true);
    const double dx = end[0] - origin[0];
    const double dy = end[1] - origin[1];
    const double dz = end[2] - origin[2];
    const double length = std::sqrt((dx * dx + dy * dy) + dz * dz);
    if (length < options_.min_range) {
      ++sorted.report.skipped.too_near;
    } else if (length > options_.max_range) {
      const double share = options_.max_range / length;
      end = {origin[0] + dx * share, origin[1] + dy * share, origin[2] + dz * share};
      add(origin, end, true);
    } else {
      add(origin, end, false);
    }
  }
  for (const Vector3f& direction : scan.no_returns) {
    ++sorted.report.points;
    const double range = std::min(options_.max_range, scan.sensor_range);
    if (!direction.allFinite() || direction == Vector3f::Zero()) {
      ++sorted.report.skipped.not_finite;
    } else if (!std::isfinite(range)) {
      ++sorted.report.skipped.no_range;
    } else {
      const Triple along = world(direction, false);
      const double length =
          std::sqrt((along[0] * along[0] + along[1] * along[1]) + along[2] * along[2]);
      const double share = range / length;
      add({center.x(), center.y(), center.z()},
          {center.x() + along[0] * share, center.y() + along[1] * share,
           center.z() + along[2] * share},
          true);
    }
  }
  for (const auto& [cell, best] : nearest) {
    sorted.beams.push_back({.origin = best.origin, .end = best.end, .cut = false});
  }
  sorted.report.end_cells = sorted.ends.size();
  return sorted;
}

void PlainGrid::prepare(const Scan& scan) {
  for (const Cell& cell : sort_out(scan).ends) cells_.try_emplace(cell, steps(options_.prior));
}

InsertReport PlainGrid::insert(const Scan& scan) {
  Sorted sorted = sort_out(scan);
  const int low = steps(options_.clamp_min);
  const int high = steps(options_.clamp_max);
  const auto moved = [&](int value, double probability) {
    if (options_.saturation == Saturation::freeze && (value <= low || value >= high)) return value;
    return std::clamp(value + step(probability, options_.prior), low, high);
  };
  for (const Cell& cell : sorted.ends) {
    const auto [place, is_new] = cells_.try_emplace(cell, steps(options_.prior));
    const int before = place->second;
    place->second = moved(before, options_.prob_hit);
    sorted.report.new_cells += is_new ? 1 : 0;
    sorted.report.hits += place->second != before ? 1 : 0;
  }
  std::vector<CellBox> boxes;
  for (const PlainBeam& beam : sorted.beams) boxes.push_back(surroundings(beam));
  for (auto& [cell, value] : cells_) {
    if (sorted.ends.contains(cell)) continue;
    bool crossed = false;
    for (std::size_t i = 0; i < boxes.size() && !crossed; ++i) {
      crossed = boxes[i].contains(cell) && plain_crosses(sorted.beams[i], cell);
    }
    if (!crossed) continue;
    const int before = value;
    value = moved(before, options_.prob_miss);
    sorted.report.misses += value != before ? 1 : 0;
  }
  return sorted.report;
}

bool PlainGrid::occupied(const Cell& cell) const {
  const auto found = value(cell);
  return found && *found > steps(options_.occupied_threshold);
}

std::optional<int> PlainGrid::value(const Cell& cell) const {
  const auto place = cells_.find(cell);
  if (place == cells_.end()) return std::nullopt;
  return place->second;
}

std::string difference(const Grid& grid, const PlainGrid& plain) {
  if (grid.cell_count() != plain.cells().size()) {
    return fmt::format("{} cells, not {}", grid.cell_count(), plain.cells().size());
  }
  for (const auto& [cell, value] : plain.cells()) {
    const auto found = grid.cell_value(cell);
    if (!found || *found != value) {
      return fmt::format("cell ({}, {}, {}) is {}, not {}", cell.x(), cell.y(), cell.z(),
                         found ? std::to_string(*found) : "absent", value);
    }
  }
  return {};
}

}  // namespace rmap::test
