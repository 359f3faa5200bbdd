#include "io/map_samples.hpp"

#include <algorithm>
#include <cmath>

namespace rmap::test {

Options with(Options options, const LoadOptions& in_memory) {
  options.layout = in_memory.layout;
  options.max_branches = in_memory.max_branches;
  options.split = in_memory.split;
  options.bad_points = in_memory.bad_points;
  options.threads = in_memory.threads;
  return options;
}

Options all_options_changed() {
  return {.resolution = 0.25,
          .prob_hit = 0.8,
          .prob_miss = 0.3,
          .clamp_min = 0.05,
          .clamp_max = 0.99,
          .prior = 0.45,
          .occupied_threshold = 0.6,
          .free_probability = 0.125,
          .saturation = Saturation::freeze,
          .min_range = 0.5,
          .max_range = 80,
          .beams = Beams::per_end_cell};
}

std::vector<Options> various_options() {
  return {{.resolution = 0.1},
          all_options_changed(),
          {.resolution = 1e-6, .free_probability = 1, .max_range = 1e-6},
          {.resolution = 1e6, .occupied_threshold = 0.999, .min_range = 1e300},
          {.resolution = 0.1, .saturation = Saturation::freeze},
          {.resolution = 0.1, .beams = Beams::per_end_cell}};
}

std::vector<LoadOptions> various_load_options() {
  return {{},
          {.layout = Layout::cells},
          {.max_branches = 4, .split = Split::linear, .threads = 0},
          {.layout = Layout::cells, .max_branches = 64, .bad_points = BadPoints::error}};
}

Grid small_map() {
  Grid grid(all_options_changed());
  grid.set_value({0, 0, 0}, 100);
  grid.set_value({7, 7, 7}, -200);
  grid.set_value({8, 0, 0}, 32767);
  grid.set_value({-1, -1, -1}, -32768);
  grid.set_value({-40, 3, 12}, 0);
  Pose turned = Pose::Identity();
  turned.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  turned.translation() << 1.5, -2.25, 0.1;
  grid.restore(History::complete, {Pose::Identity(), turned});
  return grid;
}

std::vector<Pose> random_poses(Random& random, int count) {
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) {
    Pose pose = make_pose(random.point(-1000, 1000),
                          Eigen::Quaterniond(random.real(-1, 1), random.real(-1, 1),
                                             random.real(-1, 1), random.real(-1, 1)));
    if (random.chance(0.2)) pose.translation().x() = random.chance(0.5) ? 0.0 : -0.0;
    poses.push_back(pose);
  }
  return poses;
}

Grid random_map(Random& random, const Options& options) {
  Grid grid(options);
  const auto set = [&](const Cell& cell) {
    const Cell limited = cell.cwiseMax(kMinCellIndex).cwiseMin(kMaxCellIndex);
    grid.set_value(limited, static_cast<Value>(random.integer(-32768, 32767)));
  };
  for (int i = random.integer(0, 40); i > 0; --i) set(random.cell(-30, 30));
  for (int i = random.integer(0, 20); i > 0; --i) set(random.cell(kMinCellIndex, kMaxCellIndex));
  for (int i = random.integer(0, 3); i > 0; --i) {
    const Cell center = random.cell(-100000, 100000);
    for (int j = random.integer(1, 200); j > 0; --j) set(center + random.cell(-10, 10));
  }
  if (random.chance(0.5)) {
    for (const int corner : {kMinCellIndex, kMaxCellIndex}) {
      for (int i = 0; i < 5; ++i) set(Cell::Constant(corner) + random.cell(-9, 9));
      set(Cell::Constant(corner));
    }
  }
  if (random.chance(0.5)) {
    const Cell origin = random.cell(-5, 5) * 8;
    for (BlockPosition i = 0; i < kBlockCells; ++i) set(origin + block_offset(i));
  }
  grid.restore(random.chance(0.5) ? History::complete : History::first_hit,
               random_poses(random, random.integer(0, 4)));
  return grid;
}

Grid rebuilt(const Grid& grid, Random& random, const Options& options) {
  std::vector<CellValue> cells;
  grid.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each([&](const Cell& cell, Value value) { cells.push_back({cell, value}); });
    return true;
  });
  std::shuffle(cells.begin(), cells.end(), random.engine());
  Grid other(options);
  for (const auto& [cell, value] : cells) other.set_value(cell, value);
  const auto poses = grid.scan_poses();
  other.restore(grid.history(), {poses.begin(), poses.end()});
  return other;
}

}  // namespace rmap::test
