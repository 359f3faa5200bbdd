#pragma once

#include <algorithm>
#include <optional>

#include <rmap/box.hpp>
#include <rmap/cell.hpp>
#include <rmap/function_ref.hpp>

namespace rmap {

/// A component of a direction below it, in cells, counts as zero.
inline constexpr double kZeroDirection = 0x1p-40;

/// A beam in cell units, and what it crosses: the definition that every
/// traversal must equal, bit for bit.
///
/// Plane k of an axis with direction != 0 is met at the parameter
/// t(k) = (k - origin) / direction, each operation rounded once, computed from k
/// each time and never accumulated: so t is monotone in k. Cell c is crossed when
///
///     max(0, entry of all axes) < min(1, exit of all axes),
///
/// and, on axes with direction 0, c = floor(origin). So touching a face, an edge
/// or a corner from outside is not crossing; a beam that lies in a face belongs
/// to the upper cell; nothing beyond the end is crossed. A box of cells is
/// crossed by the same rule with its outer planes, hence whenever one of its
/// cells is.
class Beam {
 public:
  /// From `origin` to `end`, both in cell units, finite and within the limits of
  /// cell indices. A component of the direction below 2^-40 counts as zero.
  /// `cut`: the beam goes on beyond its end, so it has no end cell.
  Beam(const Vector3d& origin, const Vector3d& end, bool cut);

  const Vector3d& origin() const { return origin_; }
  const Vector3d& end() const { return end_; }
  const Vector3d& direction() const { return direction_; }
  /// floor(origin): on an axis with direction 0, the only layer that is crossed.
  const Cell& origin_cell() const { return origin_cell_; }
  bool cut() const { return cut_; }

  /// A beam of length zero that is not cut: it hits its end cell and crosses nothing.
  bool crosses_nothing() const { return crosses_nothing_; }

  /// t(k): where the beam meets plane k of `axis`, whose direction is not 0.
  double parameter(int axis, std::int32_t k) const {
    return (static_cast<double>(k) - origin_[axis]) / direction_[axis];
  }

 private:
  Vector3d origin_;
  Vector3d end_;
  Vector3d direction_;
  Cell origin_cell_;
  bool cut_;
  bool crosses_nothing_;
};

/// The part of a beam within a box, as parameters: 0 <= enter < leave <= 1.
struct Crossing {
  double enter;
  double leave;
};

/// Where `beam` crosses `cells`, or nothing when it does not; `cells` is not empty.
std::optional<Crossing> crossing(const Beam& beam, const CellBox& cells);

/// Whether `beam` crosses `cell`, by the definition.
inline bool crosses(const Beam& beam, const Cell& cell) {
  return crossing(beam, box_of(cell)).has_value();
}

/// Walks through the crossed cells inside a box, from the origin to the end.
/// A step over several planes at one parameter crosses them all at once. Meets
/// exactly the cells of the box that `crosses` confirms, each once; the cost is
/// proportional to their number.
///
///     for (BeamWalk walk(beam, within); walk.more(); walk.advance()) use(walk.cell());
///
/// With an `edge`, a power of two, it walks in the same way through cubes of that many cells,
/// and cell() is the lowest cell of one; `within` must consist of whole cubes.
class BeamWalk {
 public:
  BeamWalk(const Beam& beam, const CellBox& within, std::int32_t edge = 1);

  /// Whether there is a cell; when not, neither cell() nor advance() may be called.
  bool more() const { return more_; }
  const Cell& cell() const { return cell_; }
  /// Parameter at which the beam enters the cell.
  double enter() const { return enter_; }

  void advance() {
    step();
    // Cells that are met at one parameter only are stepped over.
    while (more_ && !(enter_ < exit())) step();
  }

 private:
  double exit() const { return std::min(std::min(leave_, next_[0]), std::min(next_[1], next_[2])); }
  void step() {
    enter_ = exit();
    if (!(enter_ < leave_)) {
      more_ = false;
      return;
    }
    // Without a branch: nothing foretells which plane comes next.
    for (int axis = 0; axis < 3; ++axis) {
      const bool met = next_[axis] <= enter_;
      cell_[axis] += met ? step_[axis] : 0;
      const double further = (cell_[axis] + ahead_[axis] - beam_->origin()[axis]) / divisor_[axis];
      next_[axis] = met ? further : next_[axis];
    }
  }

  const Beam* beam_;
  Eigen::Vector3d divisor_;    ///< the direction; 1 where that is 0 and no plane is ever met
  Cell step_ = Cell::Zero();   ///< to the next cube on each axis
  Cell ahead_ = Cell::Zero();  ///< to the plane ahead
  Cell cell_;
  Eigen::Vector3d next_;  ///< parameter of the plane ahead on each axis; infinite at direction 0
  double enter_ = 0;
  double leave_ = 0;
  bool more_ = false;
};

}  // namespace rmap
