#include "query/occupancy_sum.hpp"

#include <algorithm>
#include <bit>
#include <charconv>

#include <fmt/format.h>

#include <rmap/cells.hpp>
#include <rmap/error.hpp>
#include <rmap/multiresolution.hpp>

namespace rmap {

namespace {

std::int32_t floor_divided(std::int32_t index, std::int32_t factor) {
  return index >= 0 ? index / factor : -((-index - 1) / factor) - 1;
}

// The double nearest to a decimal of 15 digits, as many as a double always keeps.
double as_written(double number) {
  const std::string text = fmt::format("{:.15g}", number);
  double written = 0;
  std::from_chars(text.data(), text.data() + text.size(), written);
  return written;
}

// A resolution that people can write gives one that they can write.
double multiplied(double resolution, int factor) {
  const double product = resolution * factor;
  return as_written(resolution) == resolution ? as_written(product) : product;
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
  CubeSplitter(const Grid& grid, FunctionRef<double(const Box&)> edge_in)
      : lattice_(grid.lattice()),
        free_probability_(grid.options().free_probability),
        edge_in_(edge_in) {}

  /// Adds the cubes for `content`: sorted cells whose indices have the same signs.
  void add(std::span<const CellValue> content) {
    if (content.empty()) return;
    const Cell first = content.front().cell;
    const Cell last = content.back().cell;
    std::uint32_t difference = 0;
    for (int axis = 0; axis < 3; ++axis) {
      difference |= static_cast<std::uint32_t>(first[axis] ^ last[axis]);
    }
    const std::int32_t edge = std::int32_t{1} << std::bit_width(difference);
    split(first.unaryExpr([&](std::int32_t index) { return index & ~(edge - 1); }), edge, content);
  }

  std::vector<QueryCuboid> take() { return std::move(cuboids_); }

 private:
  void split(const Cell& origin, std::int32_t edge, std::span<const CellValue> content) {
    if (content.empty()) return;
    const CellBox box{.min = origin, .max = origin + Cell::Constant(edge)};
    if (edge == 1 || fits(box)) {
      cuboids_.push_back(summarized(box, content));
      return;
    }
    const std::int32_t half = edge / 2;
    for (int octant = 0; octant < 8; ++octant) {
      const Cell corner = origin + half * Cell(octant & 1, (octant >> 1) & 1, octant >> 2);
      const CellBox part{.min = corner, .max = corner + Cell::Constant(half)};
      const auto end =
          std::partition_point(content.begin(), content.end(),
                               [&](const CellValue& entry) { return part.contains(entry.cell); });
      const auto count = static_cast<std::size_t>(end - content.begin());
      split(corner, half, content.first(count));
      content = content.subspan(count);
    }
  }

  bool fits(const CellBox& box) const {
    const Box metric = lattice_.metric(box);
    // An edge that equals the wish but for rounding is not too large.
    return metric.max.x() - metric.min.x() <= edge_in_(metric) * (1 + 1e-9);
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
  FunctionRef<double(const Box&)> edge_in_;
  std::vector<QueryCuboid> cuboids_;
};

}  // namespace

Grid coarsen(const Grid& grid, int factor, Criterion criterion) {
  if (factor < 1) {
    throw Error(
        ErrorKind::input,
        fmt::format("the map cannot be coarsened {} times: the factor must be at least 1", factor));
  }
  Options options = grid.options();
  options.resolution = multiplied(options.resolution, factor);
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
  coarse.restore(grid.history(), {});
  return coarse;
}

std::vector<QueryCuboid> cells_at(const Grid& grid, FunctionRef<double(const Box&)> edge_in) {
  const auto list = sorted_cells(grid);
  CubeSplitter splitter(grid, edge_in);
  // No aligned cube reaches over 0, but for that of all cells, whose edge would not fit 32 bits.
  std::span<const CellValue> rest = list;
  for (int octant = 0; octant < 8; ++octant) {
    const auto side = [&](int axis) { return ((octant >> axis) & 1) != 0 ? 0 : kMinCellIndex; };
    const Cell corner(side(0), side(1), side(2));
    const auto end = std::partition_point(rest.begin(), rest.end(), [&](const CellValue& entry) {
      return ((entry.cell.array() >= 0) == (corner.array() >= 0)).all();
    });
    const auto count = static_cast<std::size_t>(end - rest.begin());
    splitter.add(rest.first(count));
    rest = rest.subspan(count);
  }
  return splitter.take();
}

}  // namespace rmap
