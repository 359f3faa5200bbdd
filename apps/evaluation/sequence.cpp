#include "evaluation/sequence.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/simulation.hpp>

namespace rmap::evaluation {

namespace {

void add(Sequence& sequence, const Scan& scan) {
  if (!scan.origins.empty()) {
    throw Error(ErrorKind::input,
                fmt::format("scan {} of {} has an origin for each point: the experiments compare "
                            "with OctoMap, which takes one origin for a scan",
                            sequence.scans.size(), sequence.name));
  }
  Scan moved{.frame = Frame::map};
  moved.map_from_sensor.translation() =
      Vector3d(scan.map_from_sensor.translation()).cast<float>().cast<double>();
  moved.points.reserve(scan.points.size());
  for (const Vector3f& point : scan.points) {
    if (!point.allFinite()) {
      ++sequence.left_out_not_finite;
    } else if (scan.frame == Frame::map) {
      moved.points.push_back(point);
    } else {
      moved.points.push_back(transformed(scan.map_from_sensor, point).cast<float>());
    }
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

Sequence simulated_sequence(const std::string& scene, std::size_t most, std::uint64_t seed) {
  const Simulation simulation = make_simulation(scene, {.no_returns = false, .seed = seed});
  Sequence sequence{.name = scene,
                    .source = fmt::format("simulated: {}", simulation.description())};
  const std::size_t count =
      most == 0 ? simulation.size() : std::min<std::size_t>(most, simulation.size());
  for (std::size_t i = 0; i < count; ++i) add(sequence, simulation.scan(i));
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
