#include "simulation/exact_math.hpp"
#include "simulation/surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/simulation/scene.hpp>

namespace rmap {

namespace {

using simulation::dot;

// Bounding spheres are widened by this share of their coordinates, far more than rounding takes.
constexpr double kBoundsMargin = 1e-9;
// A sample is covered when the place this far (m) in front of it is solid.
constexpr double kCoverDepth = 1e-6;
constexpr double kMaxSamples = 1e8;

[[noreturn]] void refuse(const SceneObject& object, const std::string& what) {
  throw Error(ErrorKind::input, fmt::format("the scene's object '{}' {}", object.name, what));
}

void check_size(const SceneObject& object, const char* field, double value) {
  if (!(value > 0 && std::isfinite(value))) {
    refuse(object, fmt::format("has a {} of {} m: it must be positive and finite", field, value));
  }
}

void check_shape(const SceneObject& object, const CuboidShape& cuboid) {
  for (const double edge : cuboid.size) check_size(object, "size", edge);
}

void check_shape(const SceneObject& object, const SphereShape& sphere) {
  check_size(object, "radius", sphere.radius);
}

void check_shape(const SceneObject& object, const CylinderShape& cylinder) {
  check_size(object, "radius", cylinder.radius);
  check_size(object, "height", cylinder.height);
}

void check_shape(const SceneObject& object, const RectangleShape& rectangle) {
  check_size(object, "size_x", rectangle.size_x);
  check_size(object, "size_y", rectangle.size_y);
}

void check_motion(const SceneObject& object) {
  for (std::size_t i = 0; i < object.motion.size(); ++i) {
    const Waypoint& waypoint = object.motion[i];
    if (!std::isfinite(waypoint.time) || !waypoint.translation.allFinite()) {
      refuse(object, fmt::format("has a motion whose waypoint {} is not finite", i));
    }
    if (i > 0 && !(object.motion[i - 1].time < waypoint.time)) {
      refuse(object, fmt::format("has a motion whose waypoint {} is at {} s, not after the one "
                                 "before it at {} s: times must rise",
                                 i, waypoint.time, object.motion[i - 1].time));
    }
  }
}

bool visible_at(const SceneObject& object, double time) {
  return time >= object.visible_from && time < object.visible_until;
}

Vector3d translation_at(const SceneObject& object, double time) {
  const auto& motion = object.motion;
  if (motion.empty()) return Vector3d::Zero();
  const auto next = std::upper_bound(
      motion.begin(), motion.end(), time,
      [](double moment, const Waypoint& waypoint) { return moment < waypoint.time; });
  if (next == motion.begin()) return motion.front().translation;
  if (next == motion.end()) return motion.back().translation;
  const auto last = next - 1;
  const double share = (time - last->time) / (next->time - last->time);
  return last->translation + share * (next->translation - last->translation);
}

Vector3d to_object(const SceneObject& object, const Vector3d& translation, const Vector3d& point) {
  return simulation::rotated_back(
      object.map_from_object,
      point - translation - simulation::translation(object.map_from_object));
}

double signed_distance(const SceneObject& object, const Vector3d& point, double time) {
  return simulation::signed_distance(object.shape,
                                     to_object(object, translation_at(object, time), point));
}

bool solid_at(const SceneObject& object, const Vector3d& point, double time) {
  const double distance = signed_distance(object, point, time);
  return object.seen_from == Side::outside ? distance < 0 : distance > 0;
}

// Whether the solid reaches beyond the object's bounding sphere.
bool has_unbounded_solid(const SceneObject& object) {
  return object.seen_from == Side::inside || std::holds_alternative<RectangleShape>(object.shape);
}

}  // namespace

bool is_static(const SceneObject& object) {
  return object.motion.empty() && object.visible_from == -std::numeric_limits<double>::infinity() &&
         object.visible_until == std::numeric_limits<double>::infinity();
}

void Scene::add(SceneObject object) {
  std::visit([&](const auto& shape) { check_shape(object, shape); }, object.shape);
  try {
    check_pose(object.map_from_object);
  } catch (const Error& error) {
    refuse(object, fmt::format("has no valid map_from_object: {}", error.what()));
  }
  check_motion(object);
  if (!(object.visible_from < object.visible_until)) {
    refuse(object, fmt::format("is visible from {} to {} s: visible_from must be less than "
                               "visible_until",
                               object.visible_from, object.visible_until));
  }
  const simulation::BoundingSphere local = simulation::bounding_sphere(object.shape);
  const Vector3d center = simulation::transformed(object.map_from_object, local.center);
  const double margin = kBoundsMargin * (simulation::length(center) + local.radius);
  bounds_.push_back({.center = center, .radius = local.radius + margin});
  objects_.push_back(std::move(object));
}

std::optional<SurfaceHit> Scene::first_hit(const Vector3d& origin, const Vector3d& direction,
                                           double max_range, double time) const {
  if (!origin.allFinite() || !direction.allFinite() || direction == Vector3d::Zero()) {
    throw Error(ErrorKind::input,
                fmt::format("the ray from ({}, {}, {}) along ({}, {}, {}) is none: both must be "
                            "finite and the direction not zero",
                            origin.x(), origin.y(), origin.z(), direction.x(), direction.y(),
                            direction.z()));
  }
  // Scaled first, so that the length of tiny or huge directions neither vanishes nor overflows.
  const Vector3d ahead = simulation::unit(direction / direction.cwiseAbs().maxCoeff());

  std::optional<SurfaceHit> first;
  double nearest = max_range;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const SceneObject& object = objects_[i];
    if (!visible_at(object, time)) continue;
    const Vector3d translation = translation_at(object, time);

    const Vector3d to_center = bounds_[i].center + translation - origin;
    const double radius = bounds_[i].radius;
    const double along = dot(to_center, ahead);
    const double square = dot(to_center, to_center);
    if (along + radius < 0 || along - radius > nearest) continue;
    if (square - along * along > radius * radius + kBoundsMargin * square) continue;

    const auto span =
        simulation::span_on_line(object.shape, to_object(object, translation, origin),
                                 simulation::rotated_back(object.map_from_object, ahead));
    if (!span) continue;
    const bool from_outside = span->enter >= 0;
    const double range = from_outside ? span->enter : span->leave;
    if (!(range >= 0 && range <= nearest) || (first && range == nearest)) continue;

    const Vector3d outward = simulation::rotated(
        object.map_from_object, from_outside ? span->enter_normal : span->leave_normal);
    nearest = range;
    first = SurfaceHit{.range = range,
                       .point = origin + range * ahead,
                       .normal = dot(outward, ahead) > 0 ? Vector3d(-outward) : outward,
                       .object = i};
  }
  return first;
}

double Scene::distance_to_surface(const Vector3d& point, double time) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const SceneObject& object : objects_) {
    if (!visible_at(object, time)) continue;
    nearest = std::min(nearest, std::abs(signed_distance(object, point, time)));
  }
  return nearest;
}

bool Scene::solid_at(const Vector3d& point, double time) const {
  return std::any_of(objects_.begin(), objects_.end(), [&](const SceneObject& object) {
    return visible_at(object, time) && rmap::solid_at(object, point, time);
  });
}

bool Scene::covered(const Vector3d& point) const {
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const SceneObject& object = objects_[i];
    if (!is_static(object)) continue;
    const Vector3d from_center = point - bounds_[i].center;
    const bool beyond_bounds =
        dot(from_center, from_center) > bounds_[i].radius * bounds_[i].radius;
    if (beyond_bounds && !has_unbounded_solid(object)) continue;
    if (rmap::solid_at(object, point, 0)) return true;
  }
  return false;
}

std::vector<SurfaceSample> Scene::sample_surface(double spacing) const {
  if (!(spacing > 0 && std::isfinite(spacing))) {
    throw Error(ErrorKind::input,
                fmt::format("spacing is {} m: it must be positive and finite", spacing));
  }
  double count = 0;
  for (const SceneObject& object : objects_) {
    if (is_static(object)) count += simulation::sample_count_bound(object.shape, spacing);
  }
  if (!(count <= kMaxSamples)) {
    throw Error(ErrorKind::limit,
                fmt::format("a spacing of {} m takes up to {:.3g} points on the scene '{}': at "
                            "most {:.0e} are allowed",
                            spacing, count, name_, kMaxSamples));
  }

  std::vector<SurfaceSample> samples;
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const SceneObject& object = objects_[i];
    if (!is_static(object)) continue;
    const double side = object.seen_from == Side::outside ? 1 : -1;
    const auto add = [&](const Vector3d& local_point, const Vector3d& local_normal) {
      const Vector3d point = simulation::transformed(object.map_from_object, local_point);
      const Vector3d normal = side * simulation::rotated(object.map_from_object, local_normal);
      if (covered(point + kCoverDepth * normal)) return;
      samples.push_back({.point = point, .normal = normal, .object = i});
    };
    simulation::sample_surface(object.shape, spacing, add);
  }
  return samples;
}

Scene Scene::transformed(const Pose& new_from_old, std::string name) const {
  Scene moved(std::move(name));
  for (SceneObject object : objects_) {
    object.map_from_object = simulation::chained(new_from_old, object.map_from_object);
    for (Waypoint& waypoint : object.motion) {
      waypoint.translation = simulation::rotated(new_from_old, waypoint.translation);
    }
    moved.add(std::move(object));
  }
  return moved;
}

}  // namespace rmap
