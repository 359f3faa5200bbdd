#include "simulation/exact_math.hpp"
#include "simulation/objects.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/simulation/sensor.hpp>

namespace rmap {
namespace {

using test::scene_of;

// All beams from the middle of a ball of radius 5 have the length 5.
Scene ball() {
  return scene_of({.name = "ball", .shape = SphereShape{.radius = 5}, .seen_from = Side::inside});
}

// A wall across x at 3 m, so that lidar and camera see its surface at a known depth.
Scene wall() {
  SceneObject object{.name = "wall", .shape = CuboidShape{.size = {2, 100, 100}}};
  object.map_from_object.translation() = Vector3d(4, 0, 0);
  return scene_of(object);
}

Scan from_origin(const Scene& scene, const Sensor& sensor, std::uint64_t index = 0) {
  return simulate_scan(scene, sensor, Pose::Identity(), 0, index);
}

double length(const Vector3f& point) { return point.cast<double>().norm(); }

TEST(SimulatedScan, without_errors_every_beam_ends_on_the_surface) {
  const Scan scan = from_origin(ball(), {});
  const auto beams = beam_directions(SpinningLidar{}, 0);
  ASSERT_EQ(scan.points.size(), beams.size());
  EXPECT_TRUE(scan.no_returns.empty());
  for (std::size_t i = 0; i < beams.size(); ++i) {
    ASSERT_LT((scan.points[i].cast<double>() - beams[i] * 5).norm(), 5 * 0x1p-24);
  }
}

TEST(SimulatedScan, says_where_it_is_from_and_how_far_the_sensor_sees) {
  const Pose pose = simulation::pose_of_angles({1, 2, 0}, 30, 10, 5);
  const Scan scan = simulate_scan(ball(), {.model = SolidStateLidar{.max_range = 42}}, pose, 0, 17);
  EXPECT_TRUE(scan.map_from_sensor.isApprox(pose, 0));
  EXPECT_EQ(scan.frame, Frame::sensor);
  EXPECT_EQ(scan.sensor_range, 42);
  EXPECT_EQ(scan.name, "one/000017");
  EXPECT_TRUE(scan.origins.empty());
}

TEST(SimulatedScan, noise_is_normal_with_the_given_deviation) {
  constexpr double kNoise = 0.02;
  const Scan scan = from_origin(ball(), {.noise = kNoise, .seed = 9});
  const auto beams = beam_directions(SpinningLidar{}, 0);
  ASSERT_EQ(scan.points.size(), beams.size());
  const auto count = static_cast<double>(beams.size());
  double sum = 0;
  double squares = 0;
  int within_one = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double error = length(scan.points[i]) - 5;
    ASSERT_LT((scan.points[i].cast<double>() - beams[i] * (5 + error)).norm(), 1e-6)
        << "the error lies along the beam";
    sum += error;
    squares += error * error;
    if (std::abs(error) < kNoise) ++within_one;
  }
  // Five standard deviations of each estimate.
  EXPECT_NEAR(sum / count, 0, 5 * kNoise / std::sqrt(count));
  EXPECT_NEAR(std::sqrt(squares / count), kNoise, 5 * kNoise / std::sqrt(2 * count));
  EXPECT_NEAR(within_one, 0.682689 * count, 5 * std::sqrt(0.2166 * count));
}

TEST(SimulatedScan, noisy_ranges_stay_within_the_limits_of_the_sensor) {
  const Sensor sensor{.model = SpinningLidar{.min_range = 4.9, .max_range = 5.1}, .noise = 0.2};
  const Scan scan = from_origin(ball(), sensor);
  const auto range = [](const Vector3f& a, const Vector3f& b) { return length(a) < length(b); };
  const auto [nearest, farthest] =
      std::minmax_element(scan.points.begin(), scan.points.end(), range);
  EXPECT_NEAR(length(*nearest), 4.9, 1e-6);
  EXPECT_NEAR(length(*farthest), 5.1, 1e-6);
}

TEST(SimulatedScan, depth_noise_grows_with_the_square_of_the_depth) {
  DepthCamera camera;
  camera.depth_noise = 0.002;
  camera.max_range = 50;
  for (const double depth : {1.0, 3.0}) {
    const Pose pose = simulation::chained(simulation::pose_of_angles({3 - depth, 0, 0}, 0),
                                          body_from_sensor(camera));
    const Scan scan = simulate_scan(wall(), {.model = camera, .seed = 4}, pose, 0, 0);
    ASSERT_EQ(scan.points.size(), 320u * 240u);
    double squares = 0;
    double squares_at_border = 0;
    int at_border = 0;
    for (const Vector3f& point : scan.points) {
      const double error = point.z() - depth;
      squares += error * error;
      if (std::abs(point.x() / point.z()) < 0.5) continue;
      squares_at_border += error * error;
      ++at_border;
    }
    const double expected = 0.002 * depth * depth;
    const auto count = static_cast<double>(scan.points.size());
    EXPECT_NEAR(std::sqrt(squares / count), expected, 5 * expected / std::sqrt(2 * count));
    ASSERT_GT(at_border, 5000);
    EXPECT_NEAR(std::sqrt(squares_at_border / at_border), expected,
                5 * expected / std::sqrt(2.0 * at_border));
  }
}

TEST(SimulatedScan, drops_the_given_share_of_returns_and_reports_nothing_for_them) {
  const Scan whole = from_origin(ball(), {});
  for (const double dropped : {0.0, 0.3, 1.0}) {
    const Scan scan = from_origin(ball(), {.dropped = dropped, .seed = 2});
    const auto count = static_cast<double>(whole.points.size());
    EXPECT_NEAR(static_cast<double>(scan.points.size()), (1 - dropped) * count,
                5 * std::sqrt(dropped * (1 - dropped) * count));
    EXPECT_TRUE(scan.no_returns.empty());
  }
}

TEST(SimulatedScan, the_points_left_are_the_same_whatever_is_dropped) {
  const Scan all = from_origin(ball(), {.noise = 0.05});
  const Scan some = from_origin(ball(), {.noise = 0.05, .dropped = 0.5});
  auto next = all.points.begin();
  for (const Vector3f& point : some.points) {
    next = std::find(next, all.points.end(), point);
    ASSERT_NE(next, all.points.end());
    ++next;
  }
}

TEST(SimulatedScan, beams_beyond_the_range_are_no_returns_or_left_out) {
  const Sensor sensor{.model = SpinningLidar{.min_range = 0.5, .max_range = 4}};
  const Scan scan = from_origin(wall(), sensor);
  const auto beams = beam_directions(sensor.model, 0);
  std::size_t point = 0;
  std::size_t no_return = 0;
  for (const Vector3d& beam : beams) {
    const bool hits = beam.x() * 4 >= 3;
    if (hits) {
      ASSERT_LT((scan.points.at(point++).cast<double>() - beam * (3 / beam.x())).norm(), 1e-6);
    } else {
      ASSERT_EQ(scan.no_returns.at(no_return++), beam.cast<float>());
    }
  }
  EXPECT_EQ(point, scan.points.size());
  EXPECT_EQ(no_return, scan.no_returns.size());
  EXPECT_GT(point, 1000u);
  EXPECT_GT(no_return, 1000u);

  Sensor silent = sensor;
  silent.no_returns = false;
  EXPECT_TRUE(from_origin(wall(), silent).no_returns.empty());
  EXPECT_EQ(from_origin(wall(), silent).points, scan.points);
}

TEST(SimulatedScan, surfaces_nearer_than_the_least_range_report_nothing) {
  const Scan scan = from_origin(ball(), {.model = SpinningLidar{.min_range = 5.5}});
  EXPECT_TRUE(scan.points.empty());
  EXPECT_TRUE(scan.no_returns.empty());
}

TEST(SimulatedScan, chance_depends_on_seed_and_scan_alone) {
  const Sensor sensor{.noise = 0.1, .dropped = 0.2, .seed = 5};
  const Scan first = from_origin(ball(), sensor, 1);
  const Scan other_scan = from_origin(ball(), sensor, 2);
  Sensor other = sensor;
  other.seed = 6;
  const Scan other_seed = from_origin(ball(), other, 1);
  EXPECT_EQ(from_origin(ball(), sensor, 1).points, first.points);
  EXPECT_NE(other_scan.points, first.points);
  EXPECT_NE(other_seed.points, first.points);
}

TEST(SimulatedScan, refuses_a_pose_that_is_none) {
  Pose pose = Pose::Identity();
  pose(0, 0) = 2;
  EXPECT_THROW(simulate_scan(ball(), {}, pose, 0, 0), Error);
}

}  // namespace
}  // namespace rmap
