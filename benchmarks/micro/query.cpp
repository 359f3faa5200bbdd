// Asking a map: points, boxes [RMAP eq. 1], spheres, rays and all its cells.
#include "micro/street.hpp"
#include "support/random.hpp"

#include <rmap/box_query.hpp>
#include <rmap/cast_ray.hpp>
#include <rmap/cells.hpp>
#include <rmap/multiresolution.hpp>

namespace rmap::bench {
namespace {

constexpr int kQuestions = 2000;

// Points at most `reach` metres beside a surface, on each axis.
std::vector<Vector3d> points_near_surfaces(double reach) {
  test::Random random(21);
  std::vector<Vector3d> points;
  const auto last = static_cast<std::int32_t>(street_surface().size()) - 1;
  for (int i = 0; i < kQuestions; ++i) {
    const Cell& cell = street_surface()[static_cast<std::size_t>(random.integer(0, last))];
    points.emplace_back((cell.cast<double>() + Vector3d::Constant(0.5)) * 0.1 +
                        random.point(-reach, reach));
  }
  return points;
}

Box cube_around(const Vector3d& center, double edge) {
  return {center - Vector3d::Constant(edge / 2), center + Vector3d::Constant(edge / 2)};
}

void point_state(benchmark::State& state) {
  const Grid grid = street_map();
  for (const Cell& cell : street_surface()) {
    if (!right(state, grid.cell_state(cell) == State::occupied)) return;
  }
  const auto points = points_near_surfaces(0.5);
  for (auto _ : state) {
    for (const Vector3d& point : points) benchmark::DoNotOptimize(grid.state(point));
  }
  set_units(state, points.size());
}
BENCHMARK(point_state);

// The argument: edge of the box, centimetres.
void box_probability(benchmark::State& state) {
  const Grid grid = street_map();
  const double edge = static_cast<double>(state.range(0)) / 100;
  const auto points = points_near_surfaces(0.5);
  for (auto _ : state) {
    for (const Vector3d& point : points) {
      benchmark::DoNotOptimize(probability(grid, cube_around(point, edge)));
    }
  }
  set_units(state, points.size());
}
BENCHMARK(box_probability)->Arg(20)->Arg(80)->Arg(320)->Arg(1280);

void sphere_is_free(benchmark::State& state) {
  const Grid grid = street_map();
  const auto points = points_near_surfaces(1);
  for (auto _ : state) {
    for (const Vector3d& point : points) {
      benchmark::DoNotOptimize(any_occupied(grid, {.center = point, .radius = 0.4}));
    }
  }
  set_units(state, points.size());
}
BENCHMARK(sphere_is_free);

void ray(benchmark::State& state) {
  const Grid grid = street_map();
  const Vector3d origin = street_scans().front().map_from_sensor.translation();
  const auto points = points_near_surfaces(0.1);
  for (auto _ : state) {
    std::size_t hits = 0;
    for (const Vector3d& point : points) {
      hits += cast_ray(grid, origin, point - origin, 100) ? 1 : 0;
    }
    if (!right(state, hits > points.size() / 2)) return;
  }
  set_units(state, points.size());
}
BENCHMARK(ray);

void iterate(benchmark::State& state) {
  const Grid grid = street_map();
  for (auto _ : state) {
    std::size_t count = 0;
    for_each_cell(grid, {.occupied_only = true}, [&](const Cell&, Value) {
      ++count;
      return true;
    });
    if (!right(state, count == street_surface().size())) return;
  }
  set_units(state, street_surface().size());
}
BENCHMARK(iterate);

void iterate_in_order(benchmark::State& state) {
  const Grid grid = street_map();
  for (auto _ : state) {
    std::size_t count = 0;
    for (const auto& [cell, value] : cells(grid, {.occupied_only = true})) {
      benchmark::DoNotOptimize(value);
      ++count;
    }
    if (!right(state, count == street_surface().size())) return;
  }
  set_units(state, street_surface().size());
}
BENCHMARK(iterate_in_order);

}  // namespace
}  // namespace rmap::bench
