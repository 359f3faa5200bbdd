#include <cmath>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/lattice.hpp>

namespace rmap {

namespace {

constexpr double kMinResolution = 1e-6;
constexpr double kMaxResolution = 1e6;
constexpr double kSnap = 1e-6;  // in cells

constexpr char kAxisNames[] = "xyz";

// A border of a metric box in cell units, snapped to a cell border that it all but touches.
double snapped(double border) {
  const double nearest = std::round(border);
  return std::abs(border - nearest) <= kSnap ? nearest : border;
}

// Rounds to the cell that holds the point; false when it is beyond the limits.
bool round_down(const Vector3d& point_in_cells, Cell& cell) {
  for (int axis = 0; axis < 3; ++axis) {
    const double at = point_in_cells[axis];
    if (!(at >= kMinCellIndex && at < kMaxCellIndex + 1.0)) return false;
    // Not std::floor, which is a call where nothing is known of the processor.
    const auto towards_zero = static_cast<std::int32_t>(at);
    cell[axis] = towards_zero - (at < towards_zero ? 1 : 0);
  }
  return true;
}

}  // namespace

Lattice::Lattice(double resolution) : resolution_(resolution), inverse_(1 / resolution) {
  if (!(resolution >= kMinResolution && resolution <= kMaxResolution)) {
    throw Error(ErrorKind::input, fmt::format("resolution is {} m: it must lie in {} to {} m",
                                              resolution, kMinResolution, kMaxResolution));
  }
}

std::optional<Cell> cell_at(const Vector3d& point_in_cells) {
  std::optional<Cell> cell(std::in_place);
  if (!round_down(point_in_cells, *cell)) cell.reset();
  return cell;
}

std::optional<Cell> Lattice::find_cell(const Vector3d& point) const {
  return cell_at(to_cells(point));
}

Cell Lattice::cell_of(const Vector3d& point) const {
  Cell cell;
  if (round_down(to_cells(point), cell)) return cell;
  if (!point.allFinite()) {
    throw Error(ErrorKind::limit, fmt::format("the point ({}, {}, {}) m is not finite", point.x(),
                                              point.y(), point.z()));
  }
  throw Error(
      ErrorKind::limit,
      fmt::format("the point ({}, {}, {}) m is beyond what a map can hold: at a resolution "
                  "of {} m coordinates must lie within +-{:.15g} m",
                  point.x(), point.y(), point.z(), resolution_, kMaxCellIndex * resolution_));
}

CellBox Lattice::cells_of(const Box& box) const {
  if (box.min.hasNaN() || box.max.hasNaN()) {
    throw Error(ErrorKind::input, "the box has a border that is not a number");
  }
  CellBox cells;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = snapped(box.min[axis] * inverse_);
    const double high = snapped(box.max[axis] * inverse_);
    if (!(low < high)) {
      throw Error(ErrorKind::input, fmt::format("the box is empty: {} runs from {} to {} m",
                                                kAxisNames[axis], box.min[axis], box.max[axis]));
    }
    for (const double border : {low, high}) {
      if (std::isfinite(border) && !(std::abs(border) <= -static_cast<double>(kMinCellIndex))) {
        throw Error(ErrorKind::limit,
                    fmt::format("the box runs from {} to {} m in {}: at a resolution of {} m it "
                                "must lie within +-{:.15g} m",
                                box.min[axis], box.max[axis], kAxisNames[axis], resolution_,
                                kMaxCellIndex * resolution_));
      }
    }
    const CellBox all = all_cells();
    cells.min[axis] =
        std::isfinite(low) ? static_cast<std::int32_t>(std::floor(low)) : all.min[axis];
    cells.max[axis] =
        std::isfinite(high) ? static_cast<std::int32_t>(std::ceil(high)) : all.max[axis];
  }
  return cells;
}

Box Lattice::metric(const CellBox& cells) const {
  return {.min = cells.min.cast<double>() * resolution_,
          .max = cells.max.cast<double>() * resolution_};
}

}  // namespace rmap
