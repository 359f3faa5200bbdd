#include <algorithm>
#include <limits>

#include <rmap/beam.hpp>

namespace rmap {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The layer of cubes in which the beam is on `axis` just after parameter t >= 0, by its lowest
// plane: all planes with t(k) <= t lie behind it. `low` and `high` bound the answer.
std::int32_t layer_after(const Beam& beam, int axis, double t, std::int32_t low, std::int32_t high,
                         std::int32_t edge) {
  const double estimate = std::floor(beam.origin()[axis] + t * beam.direction()[axis]);
  auto layer = static_cast<std::int32_t>(
                   std::clamp(estimate, static_cast<double>(low), static_cast<double>(high))) &
               -edge;
  // The estimate is rounded; the planes' own parameters decide.
  if (beam.direction()[axis] > 0) {
    while (layer > low && beam.parameter(axis, layer) > t) layer -= edge;
    while (layer < high && beam.parameter(axis, layer + edge) <= t) layer += edge;
  } else {
    while (layer < high && beam.parameter(axis, layer + edge) > t) layer += edge;
    while (layer > low && beam.parameter(axis, layer) <= t) layer -= edge;
  }
  return layer;
}

}  // namespace

Beam::Beam(const Vector3d& origin, const Vector3d& end, bool cut)
    : origin_(origin),
      end_(end),
      direction_(end - origin),
      origin_cell_(origin.array().floor().cast<std::int32_t>()),
      cut_(cut) {
  for (double& component : direction_) {
    if (std::abs(component) < kZeroDirection) component = 0;
  }
  crosses_nothing_ = !cut && direction_ == Vector3d::Zero();
}

std::optional<Crossing> crossing(const Beam& beam, const CellBox& cells) {
  if (beam.crosses_nothing()) return std::nullopt;
  Crossing part{.enter = 0, .leave = 1};
  for (int axis = 0; axis < 3; ++axis) {
    const double direction = beam.direction()[axis];
    if (direction == 0) {
      const std::int32_t layer = beam.origin_cell()[axis];
      if (layer < cells.min[axis] || layer >= cells.max[axis]) return std::nullopt;
      continue;
    }
    const double at_min = beam.parameter(axis, cells.min[axis]);
    const double at_max = beam.parameter(axis, cells.max[axis]);
    part.enter = std::max(part.enter, direction > 0 ? at_min : at_max);
    part.leave = std::min(part.leave, direction > 0 ? at_max : at_min);
  }
  if (!(part.enter < part.leave)) return std::nullopt;
  return part;
}

BeamWalk::BeamWalk(const Beam& beam, const CellBox& within, std::int32_t edge)
    : beam_(&beam),
      divisor_((beam.direction().array() == 0).select(1.0, beam.direction())),
      cell_(beam.origin_cell().unaryExpr([edge](std::int32_t index) { return index & -edge; })),
      next_(Vector3d::Constant(kInfinity)) {
  const auto part = crossing(beam, within);
  if (!part) return;
  enter_ = part->enter;
  leave_ = part->leave;
  for (int axis = 0; axis < 3; ++axis) {
    const double direction = beam.direction()[axis];
    if (direction == 0) continue;
    cell_[axis] = layer_after(beam, axis, enter_, within.min[axis], within.max[axis] - edge, edge);
    step_[axis] = direction > 0 ? edge : -edge;
    ahead_[axis] = direction > 0 ? edge : 0;
    next_[axis] = beam.parameter(axis, cell_[axis] + ahead_[axis]);
  }
  more_ = true;
}

}  // namespace rmap
