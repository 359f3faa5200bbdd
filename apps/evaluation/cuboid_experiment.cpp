#include "evaluation/cuboid_experiment.hpp"

#include "evaluation/sequence.hpp"
#include "evaluation/stopwatch.hpp"

#include <rmap/cuboid_error.hpp>
#include <rmap/cuboid_tree.hpp>

namespace rmap::evaluation {

namespace {

constexpr std::array kBranches{8, 16, 32};
constexpr std::array kSigmas{0.5, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 0.98, 0.99, 1.0};
constexpr std::array<std::uint64_t, 7> kOmegas{1, 2, 4, 8, 16, 32, 64};

ApproximationOptions options_of(const std::string& method, double sigma, std::uint64_t omega) {
  ApproximationOptions options;
  if (method == kMidpoint) {
    options = approximation_preset("exact");
    options.method = CuboidMethod::midpoint;
    options.fill = 0.5;
    // The paper stops halving at a smallest volume.
    options.smallest_volume = omega;
  } else {
    options = approximation_preset(method);
    options.omega = omega;
  }
  options.weight = CuboidWeight::points;
  options.sigma = sigma;
  return options;
}

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

CuboidRow measure(const CloudScene& scene, const std::vector<CountedCell>& cells,
                  const ApproximationOptions& options, double quantise_ms, int repetitions) {
  std::vector<double> times;
  Approximation result;
  for (int i = 0; i < repetitions; ++i) {
    times.push_back(milliseconds_of([&] { result = approximate(cells, options); }));
  }
  const CuboidError error = cuboid_error(cells, result.cuboids);
  const CuboidBytes bytes = cuboid_bytes(cells, result.cuboids);
  CuboidRow row{
      .scene = scene.name,
      .resolution = scene.resolution,
      .ns_per_point = 1e6 * (quantise_ms + median(times)) / static_cast<double>(error.points),
      .cuboids = result.cuboids.size(),
      .unapproximated_percent = percent(error.lost_points, error.points),
      .false_percent = 100 * error.false_share(),
      .bytes = bytes.plain,
      .packed_bytes = bytes.packed};
  for (std::size_t i = 0; i < kBranches.size(); ++i) {
    row.rtree_bytes[i] =
        cuboid_tree(result.cuboids, {.max_branches = kBranches[i]}).statistics().bytes_in_use;
  }
  return row;
}

}  // namespace

Json to_json(const CloudBytes& bytes) {
  return {{"scene", bytes.scene},
          {"resolution_m", bytes.resolution},
          {"points", bytes.points},
          {"cells", bytes.cells},
          {"raw_points_bytes", bytes.raw_points},
          {"fixed_cells_bytes", bytes.fixed_cells},
          {"octomap_bytes", bytes.octomap},
          {"octomap_pruned_bytes", bytes.octomap_pruned}};
}

Json to_json(const CuboidRow& row) {
  return {{"scene", row.scene},
          {"resolution_m", row.resolution},
          {"method", row.method},
          {"varied", row.varied},
          {"sigma", row.sigma},
          {"omega_cells", row.omega},
          {"ns_per_point", row.ns_per_point},
          {"cuboids", row.cuboids},
          {"unapproximated_percent", row.unapproximated_percent},
          {"false_percent", row.false_percent},
          {"bytes", row.bytes},
          {"packed_bytes", row.packed_bytes},
          {"rtree_m8_bytes", row.rtree_bytes[0]},
          {"rtree_m16_bytes", row.rtree_bytes[1]},
          {"rtree_m32_bytes", row.rtree_bytes[2]}};
}

void cuboid_experiment(const CloudScene& scene, int repetitions, CuboidFindings& findings) {
  const Lattice lattice(scene.resolution);
  std::vector<CountedCell> cells;
  const double quantise_ms =
      milliseconds_of([&] { cells = quantize(scene.points, lattice).cells; });
  const CuboidBytes bytes = cuboid_bytes(cells, {});
  std::uint64_t points = 0;
  for (const CountedCell& cell : cells) points += cell.points;
  findings.clouds.push_back({.scene = scene.name,
                             .resolution = scene.resolution,
                             .points = points,
                             .cells = cells.size(),
                             .raw_points = bytes.raw_points,
                             .fixed_cells = bytes.voxel_keys,
                             .octomap = bytes.octomap,
                             .octomap_pruned = bytes.octomap_pruned});
  const auto add = [&](const char* method, const char* varied, double sigma, std::uint64_t omega) {
    CuboidRow row =
        measure(scene, cells, options_of(method, sigma, omega), quantise_ms, repetitions);
    row.method = method;
    row.varied = varied;
    row.sigma = sigma;
    row.omega = omega;
    findings.rows.push_back(row);
  };
  for (const char* method : {kMidpoint, kExact, kDefault}) {
    for (const double sigma : kSigmas) add(method, "sigma", sigma, 1);
    for (const std::uint64_t omega : kOmegas) add(method, "omega", 1, omega);
  }
}

std::vector<CloudScene> simulated_clouds(std::uint64_t seed) {
  const Sequence room = simulated_sequence("noisy_room", seed);
  const Sequence sphere = simulated_sequence("sphere", seed);
  return {{"noisy room", room.source, 0.05, all_points(room)},
          {"sphere", sphere.source, 0.02, all_points(sphere)}};
}

}  // namespace rmap::evaluation
