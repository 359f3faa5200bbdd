#include "grid/cell_places.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include <rmap/counted_cells.hpp>
#include <rmap/error.hpp>
#include <rmap/leaf.hpp>

namespace rmap {

namespace {

bool scan_less(const Cell& a, const Cell& b) {
  if (a.z() != b.z()) return a.z() < b.z();
  return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
}

void sort_by_scan(std::vector<CountedCell>& cells) {
  const auto less = [](const CountedCell& a, const CountedCell& b) {
    return scan_less(a.cell, b.cell);
  };
  if (!std::is_sorted(cells.begin(), cells.end(), less)) {
    std::sort(cells.begin(), cells.end(), less);
  }
}

std::uint32_t added(std::uint32_t a, std::uint32_t b) {
  return a > std::numeric_limits<std::uint32_t>::max() - b
             ? std::numeric_limits<std::uint32_t>::max()
             : a + b;
}

/// Adds up the points of cells as they come.
class CellCounter {
 public:
  void add(const Cell& cell, std::uint32_t points) {
    const std::uint32_t place =
        places_.add(cell, CellPlaces::hash_of(cell),
                    [&](std::uint32_t i) -> const Cell& { return cells_[i].cell; });
    if (place == cells_.size()) {
      cells_.push_back({cell, points});
    } else {
      cells_[place].points = added(cells_[place].points, points);
    }
  }
  std::vector<CountedCell> sorted() && {
    sort_by_scan(cells_);
    return std::move(cells_);
  }

 private:
  CellPlaces places_;
  std::vector<CountedCell> cells_;
};

}  // namespace

QuantizedPoints quantize(std::span<const Vector3f> points, const Lattice& lattice,
                         const Pose& frame) {
  QuantizedPoints result;
  CellCounter counter;
  for (const Vector3f& point : points) {
    if (!point.allFinite()) {
      ++result.not_finite;
    } else if (const auto cell = lattice.find_cell(transformed(frame, point))) {
      counter.add(*cell, 1);
    } else {
      ++result.beyond_limits;
    }
  }
  result.cells = std::move(counter).sorted();
  return result;
}

void check_cells(std::span<const CountedCell> cells) {
  for (const CountedCell& counted : cells) {
    const Cell& cell = counted.cell;
    if (!within_limits(cell)) {
      throw Error(ErrorKind::limit,
                  fmt::format("the cell ({}, {}, {}) is beyond the limits: indices lie in {} to {}",
                              cell.x(), cell.y(), cell.z(), kMinCellIndex, kMaxCellIndex));
    }
    if (counted.points == 0) {
      throw Error(ErrorKind::input,
                  fmt::format("the cell ({}, {}, {}) has no points", cell.x(), cell.y(), cell.z()));
    }
  }
}

std::vector<CountedCell> sorted_cells(std::vector<CountedCell> cells) {
  sort_by_scan(cells);
  std::size_t count = 0;
  for (const CountedCell& cell : cells) {
    if (count > 0 && cells[count - 1].cell == cell.cell) {
      cells[count - 1].points = added(cells[count - 1].points, cell.points);
    } else {
      cells[count++] = cell;
    }
  }
  cells.resize(count);
  return cells;
}

std::vector<CountedCell> occupied_cells(const Grid& grid) {
  std::vector<CountedCell> cells;
  grid.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each([&](const Cell& cell, Value value) {
      if (grid.rule().occupied(value)) cells.push_back({cell, 1});
    });
    return true;
  });
  sort_by_scan(cells);
  return cells;
}

}  // namespace rmap
