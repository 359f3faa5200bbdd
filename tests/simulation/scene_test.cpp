#include "simulation/exact_math.hpp"
#include "simulation/objects.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/simulation/scene.hpp>

namespace rmap {
namespace {

using test::random_object;
using test::scene_of;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

SceneObject unit_sphere() { return {.name = "ball", .shape = SphereShape{.radius = 1}}; }

struct KnownHit {
  Vector3d origin;
  Vector3d direction;
  double range;  // negative: none
  Vector3d normal = Vector3d::Zero();
};

void expect_hits(const Scene& scene, const std::vector<KnownHit>& known) {
  for (std::size_t i = 0; i < known.size(); ++i) {
    SCOPED_TRACE(i);
    const auto hit = scene.first_hit(known[i].origin, known[i].direction, 100);
    ASSERT_EQ(hit.has_value(), known[i].range >= 0);
    if (!hit) continue;
    EXPECT_DOUBLE_EQ(hit->range, known[i].range);
    EXPECT_LT((hit->normal - known[i].normal).norm(), 1e-15);
    const Vector3d point = known[i].origin + known[i].direction.stableNormalized() * known[i].range;
    EXPECT_LT((hit->point - point).norm(), 1e-14);
  }
}

TEST(Scene, rays_hit_a_cuboid_where_they_must) {
  expect_hits(scene_of({.name = "box", .shape = CuboidShape{.size = {2, 4, 6}}}),
              {{{-5, 0, 0}, {1, 0, 0}, 4, {-1, 0, 0}},
               {{0, 9, 1}, {0, -3, 0}, 7, {0, 1, 0}},
               {{0.5, 0.5, 20}, {0, 0, -1}, 17, {0, 0, 1}},
               {{0, 0, 0}, {0, 0, 1}, 3, {0, 0, -1}},          // from within
               {{-4, 0, 0}, {3, 4, 0}, -1},                    // past it
               {{-5, 0, 0}, {-1, 0, 0}, -1},                   // behind
               {{-5, 2, 0}, {1, 0, 0}, 4, {-1, 0, 0}},         // along a face
               {{-5, 2, 3}, {1, 0, 0}, 4, {-1, 0, 0}},         // along an edge
               {{-1, 0, 0}, {1, 0, 0}, 0, {-1, 0, 0}},         // from the surface
               {{-4, 0, 0}, {3, 0, 4e-200}, 3, {-1, 0, 0}}});  // all but parallel
}

TEST(Scene, rays_hit_a_sphere_where_they_must) {
  expect_hits(scene_of(unit_sphere()), {{{-5, 0, 0}, {1, 0, 0}, 4, {-1, 0, 0}},
                                        {{0, 0, 0}, {0, 1e-200, 0}, 1, {0, -1, 0}},
                                        {{-5, 1, 0}, {1, 0, 0}, 5, {0, 1, 0}},  // touches
                                        {{-5, 1.0001, 0}, {1, 0, 0}, -1},
                                        {{0.6, 0, 3}, {0, 0, -1}, 2.2, {0.6, 0, 0.8}}});
}

TEST(Scene, rays_hit_a_cylinder_where_they_must) {
  expect_hits(scene_of({.name = "pole", .shape = CylinderShape{.radius = 1, .height = 3}}),
              {{{-5, 0, 1}, {1, 0, 0}, 4, {-1, 0, 0}},
               {{-5, 0, 3.1}, {1, 0, 0}, -1},
               {{-5, 0, -0.1}, {1, 0, 0}, -1},
               {{0.5, 0, 8}, {0, 0, -1}, 5, {0, 0, 1}},
               {{1.5, 0, 8}, {0, 0, -1}, -1},
               {{0, 0.5, -2}, {0, 0, 1}, 2, {0, 0, -1}},
               {{0, 0, 1}, {0, 0, 1}, 2, {0, 0, -1}},  // from within, cap and wall
               {{0, 0, 1}, {0, -1, 0}, 1, {0, 1, 0}}});
}

TEST(Scene, rays_hit_the_ground_where_they_must) {
  expect_hits(scene_of({.name = "ground", .shape = RectangleShape{.size_x = 4, .size_y = 2}}),
              {{{0, 0, 2}, {0, 0, -1}, 2, {0, 0, 1}},
               {{0, 0, -2}, {0, 0, 1}, 2, {0, 0, -1}},
               {{1, 0, 3}, {0, 0, -1}, 3, {0, 0, 1}},
               {{2, 1, 3}, {0, 0, -1}, 3, {0, 0, 1}},  // the corner belongs to it
               {{2.01, 0, 3}, {0, 0, -1}, -1},
               {{0, 0, 2}, {0, 0, 1}, -1},
               {{-5, 0, 0}, {1, 0, 0}, -1}});  // edge-on it has no thickness
}

TEST(Scene, max_range_is_inclusive) {
  const Scene scene = scene_of(unit_sphere());
  EXPECT_TRUE(scene.first_hit({-5, 0, 0}, {1, 0, 0}, 4));
  EXPECT_TRUE(scene.first_hit({-5, 0, 0}, {1, 0, 0}, kInfinity));
  EXPECT_FALSE(scene.first_hit({-5, 0, 0}, {1, 0, 0}, std::nextafter(4, 0)));
}

TEST(Scene, an_empty_scene_has_no_surface) {
  const Scene scene;
  EXPECT_FALSE(scene.first_hit({0, 0, 0}, {1, 0, 0}, kInfinity));
  EXPECT_EQ(scene.distance_to_surface({1, 2, 3}), kInfinity);
  EXPECT_TRUE(scene.sample_surface(0.1).empty());
}

TEST(Scene, distances_are_those_of_closed_forms) {
  const Scene box = scene_of({.name = "box", .shape = CuboidShape{.size = {2, 4, 6}}});
  EXPECT_DOUBLE_EQ(box.distance_to_surface({3, 0, 0}), 2);
  EXPECT_DOUBLE_EQ(box.distance_to_surface({4, 6, 3}), 5);
  EXPECT_DOUBLE_EQ(box.distance_to_surface({2, 4, 5}), 3);
  EXPECT_DOUBLE_EQ(box.distance_to_surface({0, 0.5, 0}), 1);
  EXPECT_DOUBLE_EQ(box.distance_to_surface({1, 2, 3}), 0);
  const Scene ball = scene_of(unit_sphere());
  EXPECT_DOUBLE_EQ(ball.distance_to_surface({0, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(ball.distance_to_surface({0, 3, 4}), 4);
  const Scene pole = scene_of({.name = "pole", .shape = CylinderShape{.radius = 1, .height = 4}});
  EXPECT_DOUBLE_EQ(pole.distance_to_surface({3, 4, 2}), 4);
  EXPECT_DOUBLE_EQ(pole.distance_to_surface({0, 4, 8}), 5);
  EXPECT_DOUBLE_EQ(pole.distance_to_surface({0, 0, 0.25}), 0.25);
  EXPECT_DOUBLE_EQ(pole.distance_to_surface({0.75, 0, 2}), 0.25);
  const Scene ground =
      scene_of({.name = "ground", .shape = RectangleShape{.size_x = 4, .size_y = 2}});
  EXPECT_DOUBLE_EQ(ground.distance_to_surface({1, 0.5, -3}), 3);
  EXPECT_DOUBLE_EQ(ground.distance_to_surface({5, 5, 0}), 5);
  EXPECT_DOUBLE_EQ(ground.distance_to_surface({2, 4, 4}), 5);
}

// A ray that starts in free space and one that starts in the solid both end where
// the solid begins or ends, which marching sees without any intersection.
TEST(Scene, first_hit_equals_dense_marching) {
  test::Random random(10);
  SCOPED_TRACE(random.trace());
  int hits = 0;
  int changes = 0;
  for (int i = 0; i < 4000; ++i) {
    const SceneObject object = random_object(random, i % 3, 2);
    const Scene scene = scene_of(object);
    const Vector3d origin = random.point(-5, 5);
    Vector3d direction = random.direction();
    // Half of the rays at the object, a quarter along its axes.
    if (i % 8 < 4) direction = (object.map_from_object.translation() - origin).normalized();
    if (i % 16 >= 12) direction = object.map_from_object.linear().col(i % 3);
    constexpr double kRange = 15;
    const auto hit = scene.first_hit(origin, direction, kRange);

    const bool solid = scene.solid_at(origin);
    const double end = hit ? hit->range : kRange;
    double t = 0;
    while (t < end - 1e-9) {
      const Vector3d point = origin + t * direction;
      // No surface nearer than the distance to it: no step leads across one unseen.
      ASSERT_EQ(scene.solid_at(point), solid) << "case " << i << " at " << t << " of " << end;
      t += std::max(scene.distance_to_surface(point), 1e-3);
    }
    if (!hit) continue;
    ++hits;
    EXPECT_LT(scene.distance_to_surface(hit->point), 1e-13);
    EXPECT_NEAR(hit->normal.norm(), 1, 1e-13);
    EXPECT_LE(hit->normal.dot(direction), 0);
    if (scene.solid_at(origin + (hit->range + 1e-6) * direction) != solid) ++changes;
  }
  EXPECT_GT(hits, 1500);
  EXPECT_GT(changes, hits * 99 / 100);
}

TEST(Scene, the_ground_is_a_box_without_height) {
  test::Random random(13);
  SCOPED_TRACE(random.trace());
  int hits = 0;
  int differences = 0;
  for (int i = 0; i < 4000; ++i) {
    SceneObject ground = random_object(random, 3, 2);
    const auto& shape = std::get<RectangleShape>(ground.shape);
    SceneObject box = ground;
    box.shape = CuboidShape{.size = {shape.size_x, shape.size_y, 1e-12}};
    const Vector3d origin = random.point(-3, 3);
    const Vector3d direction =
        i % 2 == 0 ? random.direction()
                   : Vector3d(ground.map_from_object * random.point(-1, 1) - origin);
    const auto hit = scene_of(ground).first_hit(origin, direction, kInfinity);
    const auto expected = scene_of(box).first_hit(origin, direction, kInfinity);
    if (hit.has_value() != expected.has_value()) {
      ++differences;
      continue;
    }
    EXPECT_NEAR(scene_of(ground).distance_to_surface(origin),
                scene_of(box).distance_to_surface(origin), 1e-12);
    if (!hit) continue;
    ++hits;
    const double slope = std::abs(direction.normalized().dot(hit->normal));
    EXPECT_NEAR(hit->range, expected->range, 1e-11 / slope);
  }
  EXPECT_GT(hits, 500);
  EXPECT_LE(differences, 1) << "only rays that meet a border within rounding may differ";
}

TEST(Scene, many_objects_give_the_nearest_of_each) {
  test::Random random(11);
  SCOPED_TRACE(random.trace());
  int hits = 0;
  for (int round = 0; round < 40; ++round) {
    Scene scene("many");
    std::vector<Scene> alone;
    for (int i = 0; i < 25; ++i) {
      // Far from the origin too, where bounding spheres lose digits.
      const SceneObject object = random_object(random, i % 4, round % 4 == 3 ? 3000 : 8);
      scene.add(object);
      alone.push_back(scene_of(object));
    }
    for (int ray = 0; ray < 100; ++ray) {
      const Vector3d origin = random.point(-10, 10);
      const auto& target = scene.objects()[static_cast<std::size_t>(random.integer(0, 24))];
      const Vector3d direction =
          ray % 2 == 0
              ? random.direction()
              : Vector3d(target.map_from_object.translation() + random.point(-1, 1) - origin);
      const double max_range = ray % 3 == 0 ? random.real(0, 15) : kInfinity;
      const auto hit = scene.first_hit(origin, direction, max_range);
      std::optional<SurfaceHit> expected;
      double distance = kInfinity;
      bool solid = false;
      for (std::size_t i = 0; i < alone.size(); ++i) {
        const auto other = alone[i].first_hit(origin, direction, max_range);
        if (other && (!expected || other->range < expected->range)) {
          expected = other;
          expected->object = i;
        }
        distance = std::min(distance, alone[i].distance_to_surface(origin));
        solid = solid || alone[i].solid_at(origin);
      }
      ASSERT_EQ(hit.has_value(), expected.has_value());
      ASSERT_EQ(scene.distance_to_surface(origin), distance);
      ASSERT_EQ(scene.solid_at(origin), solid);
      if (!hit) continue;
      ++hits;
      ASSERT_EQ(hit->range, expected->range);
      ASSERT_EQ(hit->object, expected->object);
      ASSERT_EQ(hit->point, expected->point);
      ASSERT_EQ(hit->normal, expected->normal);
    }
  }
  EXPECT_GT(hits, 1200);
}

TEST(Scene, moving_objects_are_where_their_motion_says) {
  SceneObject ball = unit_sphere();
  ball.motion = {{.time = 10, .translation = {0, 0, 0}},
                 {.time = 20, .translation = {40, 0, 0}},
                 {.time = 30, .translation = {40, 0, 8}}};
  const Scene scene = scene_of(ball);
  const auto x_at = [&](double time) {
    return scene.first_hit({-100, 0, 0}, {1, 0, 0}, kInfinity, time)->range - 99;
  };
  EXPECT_DOUBLE_EQ(x_at(-5), 0);
  EXPECT_DOUBLE_EQ(x_at(10), 0);
  EXPECT_DOUBLE_EQ(x_at(12.5), 10);
  EXPECT_DOUBLE_EQ(x_at(20), 40);
  EXPECT_FALSE(scene.first_hit({-100, 0, 0}, {1, 0, 0}, kInfinity, 25));
  EXPECT_DOUBLE_EQ(scene.distance_to_surface({40, 0, 4}, 25), 1);
  EXPECT_DOUBLE_EQ(scene.distance_to_surface({40, 0, 0}, 99), 7);
  EXPECT_TRUE(scene.solid_at({40, 0, 4}, 25));
  EXPECT_FALSE(scene.solid_at({40, 0, 4}, 20));
}

TEST(Scene, objects_are_visible_from_their_first_time_until_just_before_their_last) {
  SceneObject ball = unit_sphere();
  ball.visible_from = 1;
  ball.visible_until = 2;
  const Scene scene = scene_of(ball);
  const auto seen = [&](double time) {
    const bool hit = scene.first_hit({-5, 0, 0}, {1, 0, 0}, kInfinity, time).has_value();
    EXPECT_EQ(std::isfinite(scene.distance_to_surface({0, 0, 0}, time)), hit);
    EXPECT_EQ(scene.solid_at({0, 0, 0}, time), hit);
    return hit;
  };
  EXPECT_FALSE(seen(std::nextafter(1, 0)));
  EXPECT_TRUE(seen(1));
  EXPECT_TRUE(seen(std::nextafter(2, 0)));
  EXPECT_FALSE(seen(2));
}

TEST(Scene, only_what_never_changes_is_static) {
  EXPECT_TRUE(is_static(unit_sphere()));
  SceneObject moving = unit_sphere();
  moving.motion = {{.time = 0, .translation = {1, 0, 0}}};
  EXPECT_FALSE(is_static(moving));
  SceneObject late = unit_sphere();
  late.visible_from = -100;
  EXPECT_FALSE(is_static(late));
}

TEST(Scene, a_transformed_scene_gives_transformed_answers) {
  test::Random random(12);
  SCOPED_TRACE(random.trace());
  int hits = 0;
  for (int round = 0; round < 50; ++round) {
    Scene scene("here");
    for (int i = 0; i < 8; ++i) {
      SceneObject object = random_object(random, i % 4, 4);
      if (i < 4) object.motion = {{0, random.point(-3, 3)}, {1, random.point(-3, 3)}};
      scene.add(object);
    }
    const Pose there_from_here = test::random_pose(random, 20);
    const Scene there = scene.transformed(there_from_here, "there");
    EXPECT_EQ(there.name(), "there");
    for (int ray = 0; ray < 50; ++ray) {
      const Vector3d origin = random.point(-5, 5);
      const Vector3d direction = random.direction();
      const double time = random.real(0, 1);
      const auto hit = scene.first_hit(origin, direction, kInfinity, time);
      const auto moved = there.first_hit(there_from_here * origin,
                                         there_from_here.linear() * direction, kInfinity, time);
      ASSERT_EQ(hit.has_value(), moved.has_value());
      EXPECT_NEAR(scene.distance_to_surface(origin, time),
                  there.distance_to_surface(there_from_here * origin, time), 1e-12);
      if (!hit) continue;
      ++hits;
      EXPECT_NEAR(hit->range, moved->range, 1e-7);
      EXPECT_EQ(hit->object, moved->object);
    }
  }
  EXPECT_GT(hits, 400);
}

void expect_refused(const std::function<void(SceneObject&)>& spoil, const std::string& field) {
  SceneObject object = unit_sphere();
  spoil(object);
  Scene scene("scene");
  try {
    scene.add(object);
    ADD_FAILURE() << field << " was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), testing::HasSubstr("'ball'"));
    EXPECT_THAT(error.what(), testing::HasSubstr(field));
  }
  EXPECT_TRUE(scene.objects().empty());
}

TEST(Scene, refuses_objects_that_make_no_sense_by_name_and_field) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with_shape = [](const Shape& shape) {
    return [shape](SceneObject& object) { object.shape = shape; };
  };
  expect_refused(with_shape(SphereShape{.radius = 0}), "radius of 0 m");
  expect_refused(with_shape(SphereShape{.radius = nan}), "radius");
  expect_refused(with_shape(CuboidShape{.size = {1, -1, 1}}), "size of -1 m");
  expect_refused(with_shape(CylinderShape{.radius = kInfinity, .height = 1}), "radius");
  expect_refused(with_shape(CylinderShape{.radius = 1, .height = 0}), "height");
  expect_refused(with_shape(RectangleShape{.size_x = 0, .size_y = 1}), "size_x");
  expect_refused(with_shape(RectangleShape{.size_x = 1, .size_y = nan}), "size_y");
  expect_refused([](SceneObject& object) { object.map_from_object(0, 0) = 2; }, "map_from_object");
  expect_refused(
      [](SceneObject& object) {
        object.motion = {{.time = 1}, {.time = 1}};
      },
      "waypoint 1");
  expect_refused([&](SceneObject& object) { object.motion = {{.time = nan}}; }, "waypoint 0");
  expect_refused([&](SceneObject& object) { object.visible_from = nan; }, "visible_from");
  expect_refused([](SceneObject& object) { object.visible_from = object.visible_until = 3; },
                 "visible_from");
}

TEST(Scene, refuses_rays_that_are_none) {
  const Scene scene = scene_of(unit_sphere());
  EXPECT_THROW(scene.first_hit({0, 0, 0}, {0, 0, 0}, 1), Error);
  EXPECT_THROW(scene.first_hit({0, kInfinity, 0}, {1, 0, 0}, 1), Error);
  EXPECT_THROW(scene.first_hit({0, 0, 0}, {1, std::nan(""), 0}, 1), Error);
}

}  // namespace
}  // namespace rmap
