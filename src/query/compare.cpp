#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <rmap/cells.hpp>
#include <rmap/compare.hpp>
#include <rmap/error.hpp>

namespace rmap {

MapDifference compare(const Grid& a, const Grid& b) {
  if (a.options().resolution != b.options().resolution) {
    throw Error(
        ErrorKind::input,
        fmt::format("the maps cannot be compared cell by cell: their resolutions are {} and "
                    "{} m",
                    a.options().resolution, b.options().resolution));
  }
  MapDifference difference;
  a.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each([&](const Cell& cell, Value value) {
      const bool occupied_a = a.rule().occupied(value);
      const auto other = b.cell_value(cell);
      const bool occupied_b = other && b.rule().occupied(*other);
      difference.occupied_both += occupied_a && occupied_b ? 1 : 0;
      difference.occupied_only_a += occupied_a && !occupied_b ? 1 : 0;
      difference.occupied_only_b += !occupied_a && occupied_b ? 1 : 0;
      if (!other) {
        ++difference.only_a;
        return;
      }
      ++difference.both;
      difference.state_differs += occupied_a != occupied_b ? 1 : 0;
      difference.value_differs += value != *other ? 1 : 0;
      difference.max_difference = std::max(
          difference.max_difference, std::abs(probability_of(value) - probability_of(*other)));
    });
    return true;
  });
  b.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each([&](const Cell& cell, Value value) {
      if (a.cell_value(cell)) return;
      ++difference.only_b;
      difference.occupied_only_b += b.rule().occupied(value) ? 1 : 0;
    });
    return true;
  });
  return difference;
}

CloudComparison compare_with_cloud(const Grid& grid, std::span<const Vector3f> points) {
  CloudComparison result{.points = points.size()};
  std::vector<Cell> existing;  // cells with a point, once for each
  for (const Vector3f& point : points) {
    if (!point.allFinite()) {
      ++result.not_finite;
      continue;
    }
    const auto cell = grid.lattice().find_cell(point.cast<double>());
    if (!cell) {
      ++result.beyond_limits;
      continue;
    }
    switch (grid.cell_state(*cell)) {
      case State::occupied:
        ++result.in_occupied;
        break;
      case State::free:
        ++result.in_free;
        break;
      case State::assumed_free:
        ++result.in_assumed_free;
        continue;
    }
    existing.push_back(*cell);
  }
  std::sort(existing.begin(), existing.end(), morton_less);
  existing.erase(std::unique(existing.begin(), existing.end()), existing.end());
  const auto occupied = std::count_if(existing.begin(), existing.end(), [&](const Cell& cell) {
    return grid.cell_state(cell) == State::occupied;
  });
  result.cells_without_point = grid.cell_count() - existing.size();
  result.occupied_without_point =
      count_cells(grid, {.occupied_only = true}) - static_cast<std::size_t>(occupied);
  return result;
}

}  // namespace rmap
