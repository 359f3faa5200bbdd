#include "evaluation/multiresolution_experiment.hpp"

#include <algorithm>
#include <map>

namespace rmap::evaluation {

namespace {

constexpr double kDistanceByEdge = 40;

}  // namespace

Json to_json(const MultiresolutionFindings& findings) {
  Json sizes = Json::array();
  for (const auto& size : findings.sizes) {
    sizes.push_back({{"edge_m", size.edge},
                     {"cuboids", size.cuboids},
                     {"occupied", size.occupied},
                     {"nearest_m", size.nearest},
                     {"farthest_m", size.farthest}});
  }
  return {{"sequence", findings.sequence},
          {"resolution_m", findings.resolution},
          {"sensor", {findings.sensor.x(), findings.sensor.y(), findings.sensor.z()}},
          {"fine_within_m", findings.fine_within},
          {"cells", findings.cells},
          {"query_cuboids", findings.cuboids},
          {"sizes", sizes}};
}

std::vector<Json> to_rows(const MultiresolutionFindings& findings) {
  std::vector<Json> rows;
  for (const auto& drawn : findings.boxes) {
    rows.push_back({{"sequence", findings.sequence},
                    {"min_x", drawn.box.min.x()},
                    {"min_y", drawn.box.min.y()},
                    {"min_z", drawn.box.min.z()},
                    {"edge_m", drawn.box.max.x() - drawn.box.min.x()},
                    {"mean", drawn.mean},
                    {"max", drawn.max}});
  }
  return rows;
}

MultiresolutionFindings multiresolution_experiment(const Sequence& sequence, double resolution) {
  Grid grid({.resolution = resolution});
  grid.insert(sequence.scans.front());
  MultiresolutionFindings findings{.sequence = sequence.name,
                                   .resolution = resolution,
                                   .sensor = beam_origin(sequence.scans.front(), 0),
                                   .fine_within = 2 * resolution * kDistanceByEdge,
                                   .cells = grid.cell_count()};
  const auto distance = [&](const Box& box) {
    return (box.nearest(findings.sensor) - findings.sensor).norm();
  };
  std::map<int, MultiresolutionFindings::Size> sizes;
  for (const QueryCuboid& cuboid :
       cells_at(grid, [&](const Box& box) { return distance(box) / kDistanceByEdge; })) {
    const Box box = grid.lattice().metric(cuboid.box);
    const double away = distance(box);
    const int edge = static_cast<int>(cuboid.box.extent().x());
    auto [entry, is_new] = sizes.try_emplace(edge);
    MultiresolutionFindings::Size& size = entry->second;
    size.edge = edge * resolution;
    ++size.cuboids;
    if (cuboid.max > grid.options().occupied_threshold) ++size.occupied;
    size.nearest = is_new ? away : std::min(size.nearest, away);
    size.farthest = std::max(size.farthest, away);
    findings.boxes.push_back({box, cuboid.mean, cuboid.max});
  }
  findings.cuboids = findings.boxes.size();
  for (const auto& [edge, size] : sizes) findings.sizes.push_back(size);
  return findings;
}

}  // namespace rmap::evaluation
