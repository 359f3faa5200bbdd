#pragma once

#include <optional>

#include <rmap/box.hpp>
#include <rmap/cell.hpp>

namespace rmap {

/// The lattice of cells of one resolution: what lies where, between metres and
/// cells. The only place where metres become cells, so that every part of the
/// library means the same by a point.
class Lattice {
 public:
  /// `resolution`: edge of a cell in metres, 1e-6 to 1e6; else throws Error(input).
  explicit Lattice(double resolution);

  double resolution() const { return resolution_; }
  /// 1 / resolution, rounded once: what metres are multiplied by to become cell units.
  double inverse() const { return inverse_; }

  /// Metres to cell units: point * (1 / resolution), per axis, in double.
  Vector3d to_cells(const Vector3d& point) const { return point * inverse_; }

  /// The cell that holds `point` (m). Throws Error(limit) naming the point when
  /// it is not finite or beyond the limits of cell indices.
  Cell cell_of(const Vector3d& point) const;
  /// The same, or nothing where cell_of would throw.
  std::optional<Cell> find_cell(const Vector3d& point) const;

  /// The cells that `box` (m) overlaps with positive volume. A border within
  /// 1e-6 of a cell border (in cells) snaps to it first, so that 0.3 m at 0.1 m
  /// means 3 cells; an infinite border means the limit. Throws Error(input) when
  /// the box is empty or NaN, Error(limit) when a finite border is beyond the limits.
  CellBox cells_of(const Box& box) const;

  /// The metric box of a box of cells.
  Box metric(const CellBox& cells) const;
  /// The centre of a cell, metres.
  Vector3d center(const Cell& cell) const {
    return (cell.cast<double>().array() + 0.5) * resolution_;
  }

 private:
  double resolution_;
  double inverse_;
};

/// The cell of a point given in cell units, or nothing when it is not finite or
/// beyond the limits.
std::optional<Cell> cell_at(const Vector3d& point_in_cells);

}  // namespace rmap
