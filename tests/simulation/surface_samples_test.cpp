#include "simulation/objects.hpp"
#include "support/random.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/simulation/scenario.hpp>
#include <rmap/simulation/scene.hpp>

namespace rmap {
namespace {

using test::random_object;
using test::scene_of;

double nearest(const std::vector<SurfaceSample>& samples, const Vector3d& point) {
  double square = std::numeric_limits<double>::infinity();
  for (const SurfaceSample& sample : samples) {
    square = std::min(square, (sample.point - point).squaredNorm());
  }
  return std::sqrt(square);
}

void expect_sound(const Scene& scene, const std::vector<SurfaceSample>& samples) {
  for (const SurfaceSample& sample : samples) {
    ASSERT_LT(scene.distance_to_surface(sample.point), 1e-12);
    ASSERT_NEAR(sample.normal.norm(), 1, 1e-12);
    ASSERT_FALSE(scene.solid_at(sample.point + 1e-4 * sample.normal));
    ASSERT_TRUE(scene.solid_at(sample.point - 1e-9 * sample.normal));
  }
}

TEST(SurfaceSamples, lie_on_the_surface_and_leave_no_gap) {
  test::Random random(20);
  SCOPED_TRACE(random.trace());
  int places = 0;
  for (int i = 0; i < 80; ++i) {
    const Scene scene = scene_of(random_object(random, i % 4, 3));
    const double spacing = random.real(0.08, 1.5);
    const auto samples = scene.sample_surface(spacing);
    expect_sound(scene, samples);
    for (int ray = 0; ray < 30; ++ray) {
      const Vector3d origin = random.point(-4, 4);
      const Vector3d target = samples[static_cast<std::size_t>(random.integer(
                                          0, static_cast<std::int32_t>(samples.size()) - 1))]
                                  .point +
                              random.point(-0.2, 0.2);
      const auto hit = scene.first_hit(origin, target - origin, 100);
      if (!hit) continue;
      ++places;
      ASSERT_LE(nearest(samples, hit->point), spacing) << "kind " << i % 4;
    }
  }
  EXPECT_GT(places, 1200);
}

// The twin of every distance: the nearest of many points of the surface.
TEST(SurfaceSamples, agree_with_the_distance_to_the_surface) {
  test::Random random(21);
  SCOPED_TRACE(random.trace());
  constexpr double kSpacing = 0.05;
  for (int i = 0; i < 40; ++i) {
    const Scene scene = scene_of(random_object(random, i % 4, 2));
    const auto samples = scene.sample_surface(kSpacing);
    for (int k = 0; k < 10; ++k) {
      const Vector3d point = random.point(-5, 5);
      const double distance = scene.distance_to_surface(point);
      const double sampled = nearest(samples, point);
      ASSERT_LE(distance, sampled + 1e-12);
      ASSERT_GE(distance, sampled - kSpacing);
    }
  }
}

TEST(SurfaceSamples, are_as_many_as_squares_of_the_spacing) {
  constexpr double kSpacing = 0.02;
  const double pi = std::numbers::pi;
  const std::pair<Shape, double> areas[] = {
      {CuboidShape{.size = {1, 2, 3}}, 22.0},
      {SphereShape{.radius = 1}, 4 * pi},
      {CylinderShape{.radius = 0.5, .height = 2}, 2 * pi + pi / 2},
      {RectangleShape{.size_x = 3, .size_y = 2}, 6.0}};
  for (const auto& [shape, area] : areas) {
    const Scene scene = scene_of({.name = "object", .shape = shape});
    const auto count = static_cast<double>(scene.sample_surface(kSpacing).size());
    EXPECT_NEAR(count * kSpacing * kSpacing, area, 0.03 * area);
  }
}

TEST(SurfaceSamples, are_the_same_each_time) {
  const Scene scene = make_scene("street").scene;
  const auto samples = scene.sample_surface(0.5);
  const auto again = scene.sample_surface(0.5);
  ASSERT_EQ(samples.size(), again.size());
  EXPECT_GT(samples.size(), 20000u);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(samples[i].point, again[i].point);
    ASSERT_EQ(samples[i].normal, again[i].normal);
    ASSERT_EQ(samples[i].object, again[i].object);
  }
}

TEST(SurfaceSamples, leave_out_what_another_object_covers) {
  Scene scene("table");
  scene.add({.name = "room", .shape = CuboidShape{.size = {4, 4, 4}}, .seen_from = Side::inside});
  SceneObject crate{.name = "crate", .shape = CuboidShape{.size = {1, 1, 1}}};
  crate.map_from_object.translation() = Vector3d(1.5, 0, -1.5);  // on the floor, at a wall
  scene.add(crate);
  constexpr double kSpacing = 0.1;
  const auto samples = scene.sample_surface(kSpacing);
  expect_sound(scene, samples);
  int of_crate = 0;
  for (const SurfaceSample& sample : samples) {
    if (sample.object == 1) ++of_crate;
    EXPECT_FALSE(sample.object == 0 &&
                 crate.map_from_object.translation().z() + 0.5 > sample.point.z() + 1e-9 &&
                 sample.point.x() > 1 && std::abs(sample.point.y()) < 0.5)
        << "behind or below the crate: " << sample.point.transpose();
  }
  EXPECT_EQ(of_crate, 400) << "all of its faces but those on the floor and at the wall";
  EXPECT_EQ(samples.size(), 400u + 9600u - 200u);
}

TEST(SurfaceSamples, leave_out_what_moves_or_comes_and_goes) {
  const Scene scene = make_scene("moving").scene;
  bool cart_found = false;
  for (const SceneObject& object : scene.objects()) cart_found |= object.name == "cart";
  EXPECT_TRUE(cart_found);
  for (const SurfaceSample& sample : scene.sample_surface(0.3)) {
    EXPECT_TRUE(is_static(scene.objects()[sample.object]));
  }
}

TEST(SurfaceSamples, refuse_a_spacing_that_is_none_or_too_fine) {
  const Scene scene = make_scene("room").scene;
  for (const double spacing : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
    EXPECT_THROW(scene.sample_surface(spacing), Error);
  }
  try {
    scene.sample_surface(1e-7);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::limit);
  }
}

}  // namespace
}  // namespace rmap
