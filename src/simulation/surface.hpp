#pragma once

#include <optional>

#include <rmap/function_ref.hpp>
#include <rmap/simulation/shape.hpp>

// Closed forms of the shapes, each in the shape's own frame.
namespace rmap::simulation {

/// The part of a line within a convex shape: distances along it, and the outward
/// normals at both ends. A rectangle is met in one point: enter == leave.
struct Span {
  double enter;
  double leave;
  Vector3d enter_normal;
  Vector3d leave_normal;
};

/// Where the line through `origin` along `direction` (length 1) lies within
/// `shape`; touching counts, but a line in a rectangle's plane does not meet it.
std::optional<Span> span_on_line(const Shape& shape, const Vector3d& origin,
                                 const Vector3d& direction);

/// Distance to the surface, negative within the shape (below a rectangle).
double signed_distance(const Shape& shape, const Vector3d& point);

struct BoundingSphere {
  Vector3d center;
  double radius;
};
BoundingSphere bounding_sphere(const Shape& shape);

using SurfaceVisitor = FunctionRef<void(const Vector3d& point, const Vector3d& normal)>;

/// Points spread over the surface, no place of it farther than `spacing` from one.
void sample_surface(const Shape& shape, double spacing, SurfaceVisitor visit);

/// How many points sample_surface visits: exact for flat shapes, at most twice as
/// many for round ones.
double sample_count_bound(const Shape& shape, double spacing);

}  // namespace rmap::simulation
