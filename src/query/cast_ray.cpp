#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <rmap/cast_ray.hpp>
#include <rmap/error.hpp>

namespace rmap {

namespace {

// The ray as a beam that ends at its range, or just beyond all blocks of the map.
struct Ray {
  Vector3d along;  // of length 1
  double length;   // metres
};

Ray checked_ray(const Grid& grid, const Vector3d& origin, const Vector3d& direction,
                double max_range) {
  const double scale = direction.cwiseAbs().maxCoeff();
  if (!direction.allFinite() || scale == 0) {
    throw Error(
        ErrorKind::input,
        fmt::format("the direction of the ray is ({}, {}, {}): it must be finite and not zero",
                    direction.x(), direction.y(), direction.z()));
  }
  if (!(max_range >= 0)) {
    throw Error(ErrorKind::input,
                fmt::format("the range of the ray is {} m: it must not be negative", max_range));
  }
  const Vector3d scaled = direction / scale;
  const Box bounds = grid.lattice().metric(grid.block_bounds());
  const Vector3d farthest =
      (bounds.min - origin).cwiseAbs().cwiseMax((bounds.max - origin).cwiseAbs());
  const double reach = farthest.norm() + grid.options().resolution;
  return {.along = scaled / scaled.norm(), .length = std::min(max_range, reach)};
}

// Some cells of a leaf among which are all existing ones that the beam crosses behind `enter`:
// those around its piece within the leaf.
class NearBeam {
 public:
  explicit NearBeam(const Beam& beam)
      : origin_(beam.origin()), direction_(beam.direction()), inverse_(direction_.cwiseInverse()) {}

  CellMask of(const Leaf& leaf, double enter) const {
    if (leaf.edge == 1) return leaf.cells();
    double leave = 1;
    for (int axis = 0; axis < 3; ++axis) {
      if (direction_[axis] == 0) continue;
      const std::int32_t plane = leaf.origin[axis] + (direction_[axis] > 0 ? kBlockEdge : 0);
      leave = std::min(leave, (plane - origin_[axis]) * inverse_[axis]);
    }
    Cell low;
    Cell high;
    for (int axis = 0; axis < 3; ++axis) {
      const double corner = leaf.origin[axis];
      const double from = origin_[axis] + enter * direction_[axis] - corner;
      const double to = origin_[axis] + leave * direction_[axis] - corner;
      low[axis] = offset_of(std::min(from, to) - kSpare);
      high[axis] = offset_of(std::max(from, to) + kSpare);
    }
    return leaf.cells(CellsBetween(low, high));
  }

 private:
  static constexpr double kSpare = 0x1p-10;  // cells; far above the error of a rounded point

  static std::int32_t offset_of(double at) {
    return static_cast<std::int32_t>(std::clamp(at, 0.0, kBlockEdge - 1.0));
  }

  Vector3d origin_;
  Vector3d direction_;
  Vector3d inverse_;
};

// The side through which the beam enters `cell` at parameter `enter`.
Face entry_face(const Beam& beam, const Cell& cell, double enter) {
  for (int axis = 0; axis < 3; ++axis) {
    const double direction = beam.direction()[axis];
    if (direction == 0) continue;
    const std::int32_t plane = direction > 0 ? cell[axis] : cell[axis] + 1;
    if (beam.parameter(axis, plane) == enter) {
      return static_cast<Face>(1 + 2 * axis + (direction > 0 ? 0 : 1));
    }
  }
  return Face::none;
}

}  // namespace

std::optional<RayHit> cast_ray(const Grid& grid, const Vector3d& origin, const Vector3d& direction,
                               double max_range) {
  const Ray ray = checked_ray(grid, origin, direction, max_range);
  const Lattice& lattice = grid.lattice();
  // Also when the origin lies on a face through which the beam leaves without crossing the cell.
  if (const Cell start = lattice.cell_of(origin); grid.cell_state(start) == State::occupied) {
    return RayHit{.cell = start, .point = origin, .face = Face::none, .distance = 0};
  }
  const Beam beam(lattice.to_cells(origin), lattice.to_cells(origin + ray.along * ray.length),
                  /*cut=*/true);

  std::optional<Cell> first;
  double first_enter = 1;
  const NearBeam near_beam(beam);
  grid.visit_leaves_along(beam, [&](const Leaf& leaf, double enter) {
    const CellMask cells = near_beam.of(leaf, enter);
    if (cells.none()) return first_enter;
    for (BeamWalk walk(beam, leaf.box()); walk.more() && walk.enter() < first_enter;
         walk.advance()) {
      const BlockPosition position = leaf.edge == 1 ? 0 : block_position(walk.cell());
      if (cells.test(position) && grid.rule().occupied(*leaf.find(walk.cell()))) {
        first = walk.cell();
        first_enter = walk.enter();
        break;
      }
    }
    return first_enter;
  });
  if (!first) return std::nullopt;
  const double distance = first_enter * ray.length;
  return RayHit{.cell = *first,
                .point = origin + ray.along * distance,
                .face = entry_face(beam, *first, first_enter),
                .distance = distance};
}

}  // namespace rmap
