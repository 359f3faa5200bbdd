#include "query/occupancy_sum.hpp"

#include <rmap/box_query.hpp>
#include <rmap/error.hpp>

namespace rmap {

BoxOccupancy cell_box_occupancy(const Grid& grid, const CellBox& box) {
  if (box.empty()) throw Error(ErrorKind::input, "the box of cells is empty");
  OccupancySum sum;
  BoxOccupancy answer{.box = box, .cells = box.volume()};
  const auto add = [&](Value value) {
    sum.add(value);
    if (grid.rule().occupied(value)) ++answer.occupied;
  };
  grid.visit_leaves(box, [&](const Leaf& leaf) {
    if (box.contains(leaf.box())) {
      std::for_each_n(leaf.values(), leaf.cells().count(), add);
    } else {
      leaf.for_each([&](const Cell& cell, Value value) {
        if (box.contains(cell)) add(value);
      });
    }
    return true;
  });
  answer.existing = sum.existing();
  answer.mean = sum.mean(answer.cells, grid.options().free_probability);
  answer.max = sum.max(answer.cells, grid.options().free_probability);
  return answer;
}

BoxOccupancy box_occupancy(const Grid& grid, const Box& box) {
  return cell_box_occupancy(grid, grid.lattice().cells_of(box));
}

double probability(const Grid& grid, const Box& box) { return box_occupancy(grid, box).mean; }

double max_probability(const Grid& grid, const Box& box) { return box_occupancy(grid, box).max; }

bool box_occupied(const Grid& grid, const Box& box, Criterion criterion) {
  const BoxOccupancy answer = box_occupancy(grid, box);
  return (criterion == Criterion::mean ? answer.mean : answer.max) >
         grid.options().occupied_threshold;
}

std::vector<State> states(const Grid& grid, std::span<const Vector3d> points) {
  std::vector<State> answers;
  answers.reserve(points.size());
  for (const Vector3d& point : points) answers.push_back(grid.state(point));
  return answers;
}

std::vector<double> probabilities(const Grid& grid, std::span<const Vector3d> points) {
  std::vector<double> answers;
  answers.reserve(points.size());
  for (const Vector3d& point : points) answers.push_back(grid.point_probability(point));
  return answers;
}

}  // namespace rmap
