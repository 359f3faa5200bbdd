#pragma once

#include "approximation/bit_rows.hpp"

#include <array>
#include <cstdint>

#include <rmap/cell.hpp>

namespace rmap {

/// The same set of cells in rows along each axis.
class BitGrid {
 public:
  explicit BitGrid(const Cell& size)
      : rows_{BitRows(size, 0), BitRows(size, 1), BitRows(size, 2)} {}

  const Cell& size() const { return rows_[0].size(); }
  const BitRows& rows(int axis) const { return rows_[static_cast<std::size_t>(axis)]; }
  BitRows& rows(int axis) { return rows_[static_cast<std::size_t>(axis)]; }

  bool test(const Cell& cell) const { return rows_[0].test(cell); }
  void set(const Cell& cell) {
    for (BitRows& rows : rows_) rows.set(cell);
  }
  void reset(const Cell& cell) {
    for (BitRows& rows : rows_) rows.reset(cell);
  }
  /// Removes the cells of a box.
  void reset(const CellBox& box);
  /// Number of cells in a box.
  std::int64_t count(const CellBox& box) const;
  /// Whether all cells of a box are in the set.
  bool holds(const CellBox& box) const;

 private:
  std::array<BitRows, 3> rows_;
};

}  // namespace rmap
