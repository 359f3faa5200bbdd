#include <rmap/multiresolution.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <rmap/cells.hpp>
#include <rmap/error.hpp>

#include "query/occupancy_sum.hpp"

namespace rmap {

namespace {

std::int32_t floor_divided(std::int32_t index, std::int32_t factor) {
  return index >= 0 ? index / factor : -((-index - 1) / factor) - 1;
}

std::vector<CellValue> sorted_cells(const Grid& grid) {
  std::vector<CellValue> list;
  list.reserve(grid.cell_count());
  for (const CellValue& cell : cells(grid)) list.push_back(cell);
  return list;
}

// Splits cubes of cells top down. Cells sorted along the Morton curve lie in one
// piece for every aligned cube, so a cube is a box and a span.
class CubeSplitter {
 public:
  CubeSplitter(const Grid& grid, FunctionRef<double(const Vector3d&)> edge_at)
      : lattice_(grid.lattice()),
        free_probability_(grid.options().free_probability),
        edge_at_(edge_at) {}

  void split(const Cell& origin, std::int64_t edge, std::span<const CellValue> content) {
    if (content.empty()) return;
    const CellBox box{.min = origin, .max = origin + Cell::Constant(static_cast<std::int32_t>(edge))};
    if (edge == 1 || fits(box)) {
      cuboids_.push_back(summarized(box, content));
      return;
    }
    const auto half = static_cast<std::int32_t>(edge / 2);
    for (int octant = 0; octant < 8; ++octant) {
      const Cell corner = origin + half * Cell(octant & 1, (octant >> 1) & 1, octant >> 2);
      const CellBox part{.min = corner, .max = corner + Cell::Constant(half)};
      const auto end = std::partition_point(
          content.begin(), content.end(),
          [&](const CellValue& entry) { return part.contains(entry.cell); });
      const auto count = static_cast<std::size_t>(end - content.begin());
      split(corner, half, content.first(count));
      content = content.subspan(count);
    }
  }

  std::vector<QueryCuboid> take() { return std::move(cuboids_); }

 private:
  bool fits(const CellBox& box) const {
    const Box metric = lattice_.metric(box);
    const double wanted = edge_at_((metric.min + metric.max) / 2);
    // An edge that equals the wish but for rounding is not too large.
    return metric.max.x() - metric.min.x() <= wanted * (1 + 1e-9);
  }

  QueryCuboid summarized(const CellBox& box, std::span<const CellValue> content) const {
    OccupancySum sum;
    for (const CellValue& entry : content) sum.add(entry.value);
    const double volume = box.volume();
    return {.box = box,
            .mean = sum.mean(volume, free_probability_),
            .max = sum.max(volume, free_probability_),
            .existing = sum.existing()};
  }

  const Lattice& lattice_;
  double free_probability_;
  FunctionRef<double(const Vector3d&)> edge_at_;
  std::vector<QueryCuboid> cuboids_;
};

}  // namespace

Grid coarsen(const Grid& grid, int factor, Criterion criterion) {
  if (factor < 1) {
    throw Error(ErrorKind::input,
                fmt::format("the map cannot be coarsened {} times: the factor must be at least 1",
                            factor));
  }
  Options options = grid.options();
  options.resolution *= factor;
  Grid coarse(options);
  const auto coarse_cell = [&](const Cell& cell) {
    return Cell(cell.unaryExpr([&](std::int32_t index) { return floor_divided(index, factor); }));
  };

  auto list = sorted_cells(grid);
  std::sort(list.begin(), list.end(), [&](const CellValue& a, const CellValue& b) {
    return morton_less(coarse_cell(a.cell), coarse_cell(b.cell));
  });
  const double volume = static_cast<double>(factor) * factor * factor;
  for (auto begin = list.begin(); begin != list.end();) {
    const Cell place = coarse_cell(begin->cell);
    OccupancySum sum;
    for (; begin != list.end() && coarse_cell(begin->cell) == place; ++begin) sum.add(begin->value);
    const double probability = criterion == Criterion::mean
                                   ? sum.mean(volume, options.free_probability)
                                   : sum.max(volume, options.free_probability);
    coarse.set_value(place, value_of(probability));
  }
  return coarse;
}

std::vector<QueryCuboid> cells_at(const Grid& grid, FunctionRef<double(const Vector3d&)> edge_at) {
  const auto list = sorted_cells(grid);
  CubeSplitter splitter(grid, edge_at);
  // The cube of all cells, in its eight octants: its own edge would not fit 32 bits.
  std::span<const CellValue> rest = list;
  for (int octant = 0; octant < 8; ++octant) {
    const auto side = [&](int axis) { return ((octant >> axis) & 1) != 0 ? 0 : kMinCellIndex; };
    const Cell corner(side(0), side(1), side(2));
    const auto end = std::partition_point(rest.begin(), rest.end(), [&](const CellValue& entry) {
      return ((entry.cell.array() >= 0) == (corner.array() >= 0)).all();
    });
    const auto count = static_cast<std::size_t>(end - rest.begin());
    splitter.split(corner, std::int64_t{1} << 30, rest.first(count));
    rest = rest.subspan(count);
  }
  return splitter.take();
}

}  // namespace rmap
