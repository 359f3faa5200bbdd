#include "simulation/exact_math.hpp"
#include "simulation/surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace rmap::simulation {

namespace {

// Into how many parts no longer than `spacing` a length is cut.
double parts(double whole, double spacing) { return std::max(1.0, std::ceil(whole / spacing)); }

double circle_parts(double radius, double spacing) {
  return parts(2 * std::numbers::pi * radius, spacing);
}

// Middle of part `index` of `count` equal ones of [-whole / 2, whole / 2].
double middle(double whole, std::int64_t index, std::int64_t count) {
  return whole * ((static_cast<double>(index) + 0.5) / static_cast<double>(count) - 0.5);
}

// The rectangle spanned by the edges u and v around `center`.
void sample_face(const Vector3d& center, const Vector3d& u, const Vector3d& v,
                 const Vector3d& normal, double spacing, SurfaceVisitor visit) {
  const auto columns = static_cast<std::int64_t>(parts(length(u), spacing));
  const auto rows = static_cast<std::int64_t>(parts(length(v), spacing));
  for (std::int64_t row = 0; row < rows; ++row) {
    for (std::int64_t column = 0; column < columns; ++column) {
      visit(center + u * middle(1, column, columns) + v * middle(1, row, rows), normal);
    }
  }
}

// Directions of length 1 in the xy plane, evenly spread over the circle.
void sample_circle(double radius, double spacing, FunctionRef<void(const Vector3d&)> visit) {
  const auto count = static_cast<std::int64_t>(circle_parts(radius, spacing));
  for (std::int64_t i = 0; i < count; ++i) {
    const auto [sine, cosine] = sine_cosine_of_turns(middle(1, i, count));
    visit({cosine, sine, 0});
  }
}

void sample_disc(double radius, double height, const Vector3d& normal, double spacing,
                 SurfaceVisitor visit) {
  const auto rings = static_cast<std::int64_t>(parts(radius, spacing));
  for (std::int64_t ring = 0; ring < rings; ++ring) {
    const double ring_radius = radius / 2 + middle(radius, ring, rings);
    sample_circle(ring_radius, spacing, [&](const Vector3d& outward) {
      visit(outward * ring_radius + Vector3d(0, 0, height), normal);
    });
  }
}

void sample(const CuboidShape& cuboid, double spacing, SurfaceVisitor visit) {
  for (int axis = 0; axis < 3; ++axis) {
    const int next = (axis + 1) % 3;
    const int last = (axis + 2) % 3;
    for (const double side : {-1.0, 1.0}) {
      const Vector3d normal = Vector3d::Unit(axis) * side;
      sample_face(normal * (cuboid.size[axis] / 2), Vector3d::Unit(next) * cuboid.size[next],
                  Vector3d::Unit(last) * cuboid.size[last], normal, spacing, visit);
    }
  }
}

void sample(const SphereShape& sphere, double spacing, SurfaceVisitor visit) {
  const auto rings = static_cast<std::int64_t>(parts(std::numbers::pi * sphere.radius, spacing));
  for (std::int64_t ring = 0; ring < rings; ++ring) {
    const SineCosine latitude = sine_cosine_of_turns(middle(0.5, ring, rings));
    sample_circle(sphere.radius * latitude.cosine, spacing, [&](const Vector3d& outward) {
      const Vector3d normal = outward * latitude.cosine + Vector3d(0, 0, latitude.sine);
      visit(normal * sphere.radius, normal);
    });
  }
}

void sample(const CylinderShape& cylinder, double spacing, SurfaceVisitor visit) {
  const auto rings = static_cast<std::int64_t>(parts(cylinder.height, spacing));
  for (std::int64_t ring = 0; ring < rings; ++ring) {
    const double height = cylinder.height / 2 + middle(cylinder.height, ring, rings);
    sample_circle(cylinder.radius, spacing, [&](const Vector3d& outward) {
      visit(outward * cylinder.radius + Vector3d(0, 0, height), outward);
    });
  }
  sample_disc(cylinder.radius, 0, -Vector3d::UnitZ(), spacing, visit);
  sample_disc(cylinder.radius, cylinder.height, Vector3d::UnitZ(), spacing, visit);
}

void sample(const RectangleShape& rectangle, double spacing, SurfaceVisitor visit) {
  sample_face(Vector3d::Zero(), Vector3d::UnitX() * rectangle.size_x,
              Vector3d::UnitY() * rectangle.size_y, Vector3d::UnitZ(), spacing, visit);
}

double count_bound(const CuboidShape& cuboid, double spacing) {
  const double x = parts(cuboid.size.x(), spacing);
  const double y = parts(cuboid.size.y(), spacing);
  const double z = parts(cuboid.size.z(), spacing);
  return 2 * (x * y + y * z + z * x);
}

double count_bound(const SphereShape& sphere, double spacing) {
  return parts(std::numbers::pi * sphere.radius, spacing) * circle_parts(sphere.radius, spacing);
}

double count_bound(const CylinderShape& cylinder, double spacing) {
  return (parts(cylinder.height, spacing) + 2 * parts(cylinder.radius, spacing)) *
         circle_parts(cylinder.radius, spacing);
}

double count_bound(const RectangleShape& rectangle, double spacing) {
  return parts(rectangle.size_x, spacing) * parts(rectangle.size_y, spacing);
}

}  // namespace

void sample_surface(const Shape& shape, double spacing, SurfaceVisitor visit) {
  std::visit([&](const auto& form) { sample(form, spacing, visit); }, shape);
}

double sample_count_bound(const Shape& shape, double spacing) {
  return std::visit([&](const auto& form) { return count_bound(form, spacing); }, shape);
}

}  // namespace rmap::simulation
