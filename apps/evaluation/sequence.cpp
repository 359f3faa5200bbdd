#include "evaluation/sequence.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/simulation.hpp>

namespace rmap::evaluation {

namespace {

// Height of the level ground in the library's scenes, metres.
constexpr double kGround = 0.0033;

void add(Sequence& sequence, const Scan& scan) {
  const auto rounded = [](const Vector3d& place) { return place.cast<float>().cast<double>(); };
  Scan moved{.frame = Frame::map};
  moved.map_from_sensor.translation() = rounded(scan.map_from_sensor.translation());
  moved.points.reserve(scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Vector3f& point = scan.points[i];
    if (!point.allFinite() || !beam_origin(scan, i).allFinite()) {
      ++sequence.left_out_not_finite;
      continue;
    }
    moved.points.push_back(
        scan.frame == Frame::map ? point : transformed(scan.map_from_sensor, point).cast<float>());
    if (!scan.origins.empty()) moved.origins.push_back(rounded(scan.origins[i]));
  }
  sequence.left_out_no_returns += scan.no_returns.size();
  sequence.scans.push_back(std::move(moved));
}

}  // namespace

std::size_t Sequence::beams() const {
  std::size_t beams = 0;
  for (const Scan& scan : scans) beams += scan.points.size();
  return beams;
}

Json to_json(const Sequence& sequence) {
  return {{"sequence", sequence.name},
          {"source", sequence.source},
          {"scans", sequence.scans.size()},
          {"beams", sequence.beams()},
          {"left_out_no_returns", sequence.left_out_no_returns},
          {"left_out_not_finite", sequence.left_out_not_finite}};
}

Sequence read_sequence(const std::string& name, ScanSource& source, std::size_t most) {
  Sequence sequence{.name = name, .source = name};
  Scan scan;
  while ((most == 0 || sequence.scans.size() < most) && source.next(scan)) add(sequence, scan);
  if (sequence.scans.empty()) {
    throw Error(ErrorKind::input, fmt::format("{} holds no scan", name));
  }
  return sequence;
}

Sequence simulated_sequence(const std::string& scene, std::uint64_t seed) {
  const Simulation simulation = make_simulation(scene, {.no_returns = false, .seed = seed});
  Sequence sequence{.name = scene,
                    .source = fmt::format("simulated: {}", simulation.description())};
  for (const Scan& scan : simulation) add(sequence, scan);
  return sequence;
}

Sequence campus_sequence(std::size_t most, double lift, std::uint64_t seed) {
  constexpr int kScansOfLoop = 420;
  constexpr std::size_t kScans = 70;
  const Simulation simulation =
      make_simulation("campus", {.scans = kScansOfLoop,
                                 .sensor = SpinningLidar{.channels = 64,
                                                         .min_elevation = -25,
                                                         .max_elevation = 15,
                                                         .azimuth_steps = 1024,
                                                         .min_range = 0.5,
                                                         .max_range = 50},
                                 .no_returns = false,
                                 .seed = seed});
  Sequence sequence{
      .name = "campus",
      .source = fmt::format("simulated: the first sixth of {}, 64 x 1024 beams of up to 50 m a "
                            "scan without noise, the ground at {:.4f} m",
                            simulation.description(), kGround + lift)};
  const std::size_t count = most == 0 ? kScans : std::min(most, kScans);
  for (std::size_t i = 0; i < count; ++i) {
    Scan scan = simulation.scan(i);
    scan.map_from_sensor.translation().z() += lift;
    add(sequence, scan);
  }
  return sequence;
}

std::vector<Vector3f> all_points(const Sequence& sequence) {
  std::vector<Vector3f> points;
  points.reserve(sequence.beams());
  for (const Scan& scan : sequence.scans) {
    points.insert(points.end(), scan.points.begin(), scan.points.end());
  }
  return points;
}

}  // namespace rmap::evaluation
