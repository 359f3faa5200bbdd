#include "support/cell_sets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include <rmap/cuboid_frame.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

using Eigen::Matrix3d;
using test::Random;

constexpr double kDegree = std::numbers::pi / 180;
constexpr std::size_t kPoints = 60000;

double angle_of(const Matrix3d& rotation) { return Eigen::AngleAxisd(rotation).angle(); }

/// The 24 rotations that take axes to axes.
std::vector<Matrix3d> symmetries() {
  std::vector<Matrix3d> all;
  for (int first = 0; first < 3; ++first) {
    for (int second = 0; second < 3; ++second) {
      if (second == first) continue;
      for (const double a : {1.0, -1.0}) {
        for (const double b : {1.0, -1.0}) {
          Matrix3d rotation;
          rotation.row(0) = a * Vector3d::Unit(first).transpose();
          rotation.row(1) = b * Vector3d::Unit(second).transpose();
          rotation.row(2) = rotation.row(0).cross(rotation.row(1));
          all.push_back(rotation);
        }
      }
    }
  }
  return all;
}

double nearest_angle(const Matrix3d& rotation) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Matrix3d& symmetry : symmetries()) {
    nearest = std::min(nearest, angle_of(symmetry * rotation));
  }
  return nearest;
}

std::vector<Vector3f> turned(const std::vector<Vector3f>& points, const Matrix3d& rotation) {
  std::vector<Vector3f> other;
  for (const Vector3f& point : points) {
    other.push_back((rotation * point.cast<double>()).cast<float>());
  }
  return other;
}

Matrix3d tilt(double yaw, double pitch, double roll) {
  return (Eigen::AngleAxisd(yaw * kDegree, Vector3d::UnitZ()) *
          Eigen::AngleAxisd(pitch * kDegree, Vector3d::UnitY()) *
          Eigen::AngleAxisd(roll * kDegree, Vector3d::UnitX()))
      .toRotationMatrix();
}

void expect_identity(const FrameEstimate& estimate) {
  EXPECT_TRUE(estimate.identity);
  EXPECT_TRUE(estimate.frame.matrix().isApprox(Pose::Identity().matrix(), 0));
  EXPECT_FALSE(estimate.why.empty());
}

TEST(CuboidFrame, TiltedRoomsAreFound) {
  int compared = 0;
  ASSERT_EQ(symmetries().size(), 24u);
  for (const auto& [yaw, pitch, roll] :
       {std::tuple{30.0, 8.0, -5.0}, {12.5, 0.0, 0.0}, {-40.0, 3.0, 2.0}, {100.0, -20.0, 33.0}}) {
    Random random(static_cast<std::uint64_t>(compared));
    SCOPED_TRACE(random.trace());
    const Matrix3d rotation = tilt(yaw, pitch, roll);
    const auto points = turned(test::noisy_room_points(random, kPoints, 0.01), rotation);
    const FrameEstimate estimate = estimate_frame(points, {.resolution = 0.1});
    ASSERT_FALSE(estimate.identity) << estimate.why;
    const Matrix3d found = estimate.frame.linear();
    EXPECT_LT(nearest_angle(found * rotation), 0.1 * kDegree);
    EXPECT_LE(angle_of(found), nearest_angle(found) + 1e-9);  // nearest to none
    EXPECT_EQ(Vector3d(estimate.frame.translation()), Vector3d(Vector3d::Zero()));
    EXPECT_NO_THROW(check_pose(estimate.frame));
    EXPECT_GE(estimate.entropy_gain, 0.3);
    EXPECT_LE(estimate.cuboid_ratio, 0.9);
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

TEST(CuboidFrame, CloudsWithoutBetterAxesStayAsTheyAre) {
  Random random(1);
  SCOPED_TRACE(random.trace());
  std::vector<Vector3f> cube;
  std::vector<Vector3f> sphere;
  for (int i = 0; i < 20000; ++i) {
    cube.push_back(random.point(-2, 2).cast<float>());
    sphere.push_back((2 * random.direction()).cast<float>());
  }
  const FrameOptions options{.resolution = 0.1, .outer = 1};
  expect_identity(estimate_frame(cube, options));
  expect_identity(estimate_frame(sphere, options));
  expect_identity(estimate_frame(test::noisy_room_points(random, kPoints, 0.01), options));
}

TEST(CuboidFrame, OrderThreadsAndWhatIsNotFiniteDoNotMatter) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Random random(2);
  SCOPED_TRACE(random.trace());
  auto points = turned(test::noisy_room_points(random, 20000, 0.01), tilt(20, 5, 7));
  const FrameEstimate expected = estimate_frame(points, {.resolution = 0.1});
  points.emplace_back(kNan, 1.0F, 2.0F);
  points.emplace_back(0.0F, kInfinity, 0.0F);
  points.emplace_back(0.0F, 0.0F, -kInfinity);
  std::shuffle(points.begin(), points.end(), random.engine());
  const FrameEstimate estimate = estimate_frame(points, {.resolution = 0.1, .threads = 3});
  EXPECT_EQ(estimate.frame.matrix(), expected.frame.matrix());
  EXPECT_EQ(estimate.why, expected.why);
  EXPECT_EQ(estimate.entropy_gain, expected.entropy_gain);
  EXPECT_EQ(estimate.cuboid_ratio, expected.cuboid_ratio);
}

TEST(CuboidFrame, PoorCloudsKeepTheirFrame) {
  const FrameOptions options{.resolution = 0.1};
  expect_identity(estimate_frame({}, options));
  expect_identity(estimate_frame(std::vector<Vector3f>{{1, 2, 3}}, options));
  expect_identity(estimate_frame(std::vector<Vector3f>(500, Vector3f(1, 2, 3)), options));
  std::vector<Vector3f> line;
  for (int i = 0; i < 2000; ++i) line.emplace_back(0.01F * static_cast<float>(i), 0.0F, 0.0F);
  expect_identity(estimate_frame(line, options));
  // Across the axes a line may be turned, but is not lost.
  EXPECT_NO_THROW(estimate_frame(turned(line, tilt(30, 20, 10)), options));
  EXPECT_THROW(estimate_frame(line, {.resolution = 0}), Error);
  EXPECT_THROW(estimate_frame(line, {.resolution = 0.1, .outer = 4}), Error);
  EXPECT_THROW(estimate_frame(line, {.resolution = 0.1, .outer = -1}), Error);
  EXPECT_THROW(estimate_frame(line, {.resolution = 0.1, .threads = -1}), Error);
  EXPECT_THROW(estimate_frame(line, {.resolution = std::nan("")}), Error);
}

// No cell holds such points: they say nothing.
TEST(CuboidFrame, HugeCoordinatesKeepTheFrame) {
  Random random(3);
  SCOPED_TRACE(random.trace());
  for (const double scale : {1e9, 1e15, 1e30}) {
    auto points = turned(test::noisy_room_points(random, 3000, 0.01), tilt(20, 5, 7));
    std::vector<Vector3f> scaled;
    for (const Vector3f& point : points) scaled.push_back(point * static_cast<float>(scale));
    expect_identity(estimate_frame(scaled, {.resolution = 0.1}));
    points.push_back(scaled.front());
    EXPECT_NO_THROW(estimate_frame(points, {.resolution = 0.1}));
  }
}

TEST(CuboidFrame, EveryResolutionOfALatticeWillDo) {
  Random random(4);
  SCOPED_TRACE(random.trace());
  const auto points = test::noisy_room_points(random, 2000, 0.01);
  for (const double resolution : {1e-6, 1e-3, 1e3, 1e6}) {
    expect_identity(estimate_frame(points, {.resolution = resolution}));
  }
}

TEST(CuboidFrame, ThePhasePutsWallsIntoTheMiddleOfCells) {
  Random random(5);
  SCOPED_TRACE(random.trace());
  std::vector<Vector3f> points;  // planes on the borders of cells
  for (int i = 0; i < 6000; ++i) {
    Vector3d point = random.point(0, 3);
    point[i % 3] = 1 + random.gaussian(0.01);
    points.push_back(point.cast<float>());
  }
  const Pose frame = Pose::Identity();
  EXPECT_EQ(phase_shift(points, frame, 0.1, CuboidPhase::zero), Vector3d(Vector3d::Zero()));
  const Vector3d shift = phase_shift(points, frame, 0.1, CuboidPhase::centre);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(shift[axis], 0.05, 0.025);
  EXPECT_EQ(phase_shift({}, frame, 0.1, CuboidPhase::centre), Vector3d(Vector3d::Zero()));
}

}  // namespace
}  // namespace rmap
