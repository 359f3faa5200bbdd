#include "simulation/surface.hpp"

#include "simulation/exact_math.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rmap::simulation {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The whole line, until it is cut down to what lies within a shape.
Span whole_line() {
  return {.enter = -kInfinity,
          .leave = kInfinity,
          .enter_normal = Vector3d::Zero(),
          .leave_normal = Vector3d::Zero()};
}

// Cuts `span` down to low <= axis <= high; false when nothing is left.
bool cut_to_slab(Span& span, int axis, double low, double high, const Vector3d& origin,
                 const Vector3d& direction) {
  if (direction[axis] == 0) return origin[axis] >= low && origin[axis] <= high;
  const bool forward = direction[axis] > 0;
  const double enter = ((forward ? low : high) - origin[axis]) / direction[axis];
  const double leave = ((forward ? high : low) - origin[axis]) / direction[axis];
  const Vector3d ahead = Vector3d::Unit(axis) * (forward ? 1 : -1);
  if (enter > span.enter) {
    span.enter = enter;
    span.enter_normal = -ahead;
  }
  if (leave < span.leave) {
    span.leave = leave;
    span.leave_normal = ahead;
  }
  return span.enter <= span.leave;
}

std::optional<Span> span_of(const CuboidShape& cuboid, const Vector3d& origin,
                            const Vector3d& direction) {
  Span span = whole_line();
  for (int axis = 0; axis < 3; ++axis) {
    const double half = cuboid.size[axis] / 2;
    if (!cut_to_slab(span, axis, -half, half, origin, direction)) return std::nullopt;
  }
  return span;
}

std::optional<Span> span_of(const SphereShape& sphere, const Vector3d& origin,
                            const Vector3d& direction) {
  // Measured from the line's nearest point, which keeps the digits of far spheres.
  const double nearest = -dot(origin, direction);
  const Vector3d foot = origin + nearest * direction;
  const double square = sphere.radius * sphere.radius - dot(foot, foot);
  if (square < 0) return std::nullopt;
  const double half = std::sqrt(square);
  const double enter = nearest - half;
  const double leave = nearest + half;
  return Span{.enter = enter,
              .leave = leave,
              .enter_normal = unit(origin + enter * direction),
              .leave_normal = unit(origin + leave * direction)};
}

std::optional<Span> span_of(const CylinderShape& cylinder, const Vector3d& origin,
                            const Vector3d& direction) {
  Span span = whole_line();
  const Vector3d across(direction.x(), direction.y(), 0);
  const Vector3d start(origin.x(), origin.y(), 0);
  const double slope = dot(across, across);
  const double nearest = slope == 0 ? 0 : -dot(start, across) / slope;
  const Vector3d foot = start + nearest * across;
  const double square = cylinder.radius * cylinder.radius - dot(foot, foot);
  if (square < 0) return std::nullopt;
  if (slope > 0) {
    const double half = std::sqrt(square / slope);
    span.enter = nearest - half;
    span.leave = nearest + half;
    span.enter_normal = (start + span.enter * across) / cylinder.radius;
    span.leave_normal = (start + span.leave * across) / cylinder.radius;
  }
  if (!cut_to_slab(span, 2, 0, cylinder.height, origin, direction)) return std::nullopt;
  return span;
}

std::optional<Span> span_of(const RectangleShape& rectangle, const Vector3d& origin,
                            const Vector3d& direction) {
  if (direction.z() == 0) return std::nullopt;
  const double range = -origin.z() / direction.z();
  const Vector3d point = origin + range * direction;
  if (!(std::abs(point.x()) <= rectangle.size_x / 2 &&
        std::abs(point.y()) <= rectangle.size_y / 2)) {
    return std::nullopt;
  }
  return Span{.enter = range,
              .leave = range,
              .enter_normal = Vector3d::UnitZ(),
              .leave_normal = Vector3d::UnitZ()};
}

// Distance to the surface of a product of intervals, from how far the point lies
// beyond each of them; negative when it is within all.
double distance_beyond(const Vector3d& beyond) {
  const double deepest = beyond.maxCoeff();
  return deepest <= 0 ? deepest : length(beyond.cwiseMax(0));
}

double distance_to(const CuboidShape& cuboid, const Vector3d& point) {
  return distance_beyond(point.cwiseAbs() - cuboid.size / 2);
}

double distance_to(const SphereShape& sphere, const Vector3d& point) {
  return length(point) - sphere.radius;
}

double distance_to(const CylinderShape& cylinder, const Vector3d& point) {
  const double radial = length({point.x(), point.y(), 0}) - cylinder.radius;
  const double axial = std::max(-point.z(), point.z() - cylinder.height);
  return distance_beyond({radial, axial, -kInfinity});
}

double distance_to(const RectangleShape& rectangle, const Vector3d& point) {
  const double beyond_x = std::max(0.0, std::abs(point.x()) - rectangle.size_x / 2);
  const double beyond_y = std::max(0.0, std::abs(point.y()) - rectangle.size_y / 2);
  const double distance = length({beyond_x, beyond_y, point.z()});
  const bool below = point.z() < 0 && beyond_x == 0 && beyond_y == 0;
  return below ? -distance : distance;
}

BoundingSphere bounds_of(const CuboidShape& cuboid) {
  return {.center = Vector3d::Zero(), .radius = length(cuboid.size) / 2};
}

BoundingSphere bounds_of(const SphereShape& sphere) {
  return {.center = Vector3d::Zero(), .radius = sphere.radius};
}

BoundingSphere bounds_of(const CylinderShape& cylinder) {
  const double half = cylinder.height / 2;
  return {.center = {0, 0, half}, .radius = length({cylinder.radius, half, 0})};
}

BoundingSphere bounds_of(const RectangleShape& rectangle) {
  return {.center = Vector3d::Zero(),
          .radius = length({rectangle.size_x, rectangle.size_y, 0}) / 2};
}

}  // namespace

std::optional<Span> span_on_line(const Shape& shape, const Vector3d& origin,
                                 const Vector3d& direction) {
  return std::visit([&](const auto& form) { return span_of(form, origin, direction); }, shape);
}

double signed_distance(const Shape& shape, const Vector3d& point) {
  return std::visit([&](const auto& form) { return distance_to(form, point); }, shape);
}

BoundingSphere bounding_sphere(const Shape& shape) {
  return std::visit([](const auto& form) { return bounds_of(form); }, shape);
}

}  // namespace rmap::simulation
