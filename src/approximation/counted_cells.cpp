#include "approximation/cell_keys.hpp"

#include <algorithm>
#include <limits>
#include <utility>

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

bool counted_less(const CountedCell& a, const CountedCell& b) { return scan_less(a.cell, b.cell); }

void sort_by_scan(std::vector<CountedCell>& cells) {
  if (!std::is_sorted(cells.begin(), cells.end(), counted_less)) {
    std::sort(cells.begin(), cells.end(), counted_less);
  }
}

std::uint32_t added(std::uint32_t a, std::uint32_t b) {
  return a > std::numeric_limits<std::uint32_t>::max() - b
             ? std::numeric_limits<std::uint32_t>::max()
             : a + b;
}

// Points whose cells are sorted at a time: what they take stays in the nearer memory.
constexpr std::size_t kPiece = std::size_t{1} << 20;

/// Counts the points of cells, piece by piece.
class CellCounter {
 public:
  explicit CellCounter(std::size_t points) { cells_.reserve(std::min(points, kPiece)); }

  void add(const Cell& cell) {
    cells_.push_back(cell);
    if (cells_.size() == kPiece) count_piece();
  }
  std::vector<CountedCell> counted() && {
    count_piece();
    while (pieces_.size() > 1) merge_neighbours();
    return sorted_cells(std::move(counted_));
  }

 private:
  void count_piece() {
    if (cells_.empty()) return;
    CellBox box = box_of(cells_.front());
    for (const Cell& cell : cells_) {
      box.min = box.min.cwiseMin(cell);
      box.max = box.max.cwiseMax(cell);
    }
    box.max += Cell::Ones();
    if (const auto keys = CellKeys::of(box)) {
      count_keys(*keys);
    } else {
      std::sort(cells_.begin(), cells_.end(), scan_less);
      count_runs(cells_, [](const Cell& cell) -> const Cell& { return cell; });
    }
    cells_.clear();
  }

  // Two pieces become one; the last of an odd number stays.
  void merge_neighbours() {
    std::vector<std::size_t> merged;
    for (std::size_t i = 0; i < pieces_.size(); i += 2) {
      const auto begin_of = [&](std::size_t piece) {
        const std::size_t begin = piece < pieces_.size() ? pieces_[piece] : counted_.size();
        return counted_.begin() + static_cast<std::ptrdiff_t>(begin);
      };
      std::inplace_merge(begin_of(i), begin_of(i + 1), begin_of(i + 2), counted_less);
      merged.push_back(pieces_[i]);
    }
    pieces_ = std::move(merged);
  }

  void count_keys(const CellKeys& keys) {
    keys_.clear();
    for (const Cell& cell : cells_) keys_.push_back(keys.key(cell));
    sort_keys(keys_, keys.bits(), spare_);
    count_runs(keys_, [&](std::uint64_t key) { return keys.cell(key); });
  }

  // Equal ones follow one another.
  template <class Item, class CellOf>
  void count_runs(const std::vector<Item>& items, CellOf&& cell_of) {
    pieces_.push_back(counted_.size());
    for (std::size_t begin = 0, end = 0; begin < items.size(); begin = end) {
      while (end < items.size() && items[end] == items[begin]) ++end;
      counted_.push_back({cell_of(items[begin]), static_cast<std::uint32_t>(end - begin)});
    }
  }

  std::vector<Cell> cells_;
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint64_t> spare_;
  std::vector<CountedCell> counted_;
  std::vector<std::size_t> pieces_;  // where each begins among the counted
};

}  // namespace

QuantizedPoints quantize(std::span<const Vector3f> points, const Lattice& lattice,
                         const Pose& frame) {
  QuantizedPoints result;
  CellCounter counter(points.size());
  for (const Vector3f& point : points) {
    if (!point.allFinite()) {
      ++result.not_finite;
    } else if (const auto cell = lattice.find_cell(transformed(frame, point))) {
      counter.add(*cell);
    } else {
      ++result.beyond_limits;
    }
  }
  result.cells = std::move(counter).counted();
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
