#include "simulation/exact_math.hpp"

#include "support/random.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace rmap::simulation {
namespace {

TEST(ExactMath, sine_and_cosine_equal_those_of_the_c_library_to_the_last_bits) {
  test::Random random(1);
  SCOPED_TRACE(random.trace());
  int cases = 0;
  for (int i = 0; i < 20000; ++i) {
    // Within one turn, where the C library's argument is rounded little.
    const int step = i / 4 - 2500;
    const double turns = i % 4 == 0 ? static_cast<double>(step) / 5000 : random.real(-0.5, 0.5);
    const auto [sine, cosine] = sine_cosine_of_turns(turns);
    const double angle = 2 * std::numbers::pi * turns;
    ASSERT_NEAR(sine, std::sin(angle), 6e-16) << turns;
    ASSERT_NEAR(cosine, std::cos(angle), 6e-16) << turns;
    ++cases;
  }
  EXPECT_EQ(cases, 20000);
}

TEST(ExactMath, quarters_of_a_turn_are_exact) {
  const double sines[] = {0, 1, 0, -1};
  for (int quarter = -9; quarter <= 9; ++quarter) {
    const auto [sine, cosine] = sine_cosine_of_turns(quarter / 4.0);
    EXPECT_EQ(sine, sines[((quarter % 4) + 4) % 4]) << quarter;
    EXPECT_EQ(cosine, sines[((quarter % 4) + 5) % 4]) << quarter;
  }
  EXPECT_EQ(sine_cosine_of_degrees(90).cosine, 0);
  EXPECT_DOUBLE_EQ(sine_cosine_of_degrees(30).sine, 0.5);
}

TEST(ExactMath, whole_turns_change_nothing) {
  test::Random random(2);
  SCOPED_TRACE(random.trace());
  for (int i = 0; i < 1000; ++i) {
    const double turns = std::ldexp(random.integer(-4096, 4096), -13);
    const double more = std::ldexp(random.integer(-100, 100), random.integer(0, 30));
    EXPECT_EQ(sine_cosine_of_turns(turns + more).sine, sine_cosine_of_turns(turns).sine);
  }
}

TEST(ExactMath, logarithm_equals_that_of_the_c_library_to_the_last_bits) {
  test::Random random(3);
  SCOPED_TRACE(random.trace());
  EXPECT_EQ(natural_log(1), 0);
  for (int i = 0; i < 20000; ++i) {
    const double x = i % 2 == 0 ? random.real(0x1p-53, 2)
                                : std::ldexp(random.real(0.5, 1), random.integer(-1000, 1000));
    const double expected = std::log(x);
    ASSERT_NEAR(natural_log(x), expected, 1e-15 * std::abs(expected) + 1e-17) << x;
  }
}

TEST(ExactMath, poses_of_angles_turn_by_yaw_then_pitch_then_roll) {
  test::Random random(4);
  SCOPED_TRACE(random.trace());
  for (int i = 0; i < 1000; ++i) {
    const Vector3d position = random.point(-10, 10);
    const Vector3d angles = random.point(-180, 180);
    const Vector3d radians = angles * (std::numbers::pi / 180);
    Pose expected = Pose::Identity();
    expected.translate(position);
    expected.rotate(Eigen::AngleAxisd(radians.x(), Vector3d::UnitZ()));
    expected.rotate(Eigen::AngleAxisd(radians.y(), Vector3d::UnitY()));
    expected.rotate(Eigen::AngleAxisd(radians.z(), Vector3d::UnitX()));
    const Pose pose = pose_of_angles(position, angles.x(), angles.y(), angles.z());
    ASSERT_TRUE(pose.isApprox(expected, 1e-14));

    const Pose other = pose_of_angles(random.point(-10, 10), angles.z(), angles.x(), angles.y());
    const Vector3d point = random.point(-5, 5);
    ASSERT_TRUE(chained(pose, other).isApprox(pose * other, 1e-14));
    ASSERT_TRUE(transformed(pose, point).isApprox(pose * point, 1e-13));
    ASSERT_TRUE(rotated_back(pose, rotated(pose, point)).isApprox(point, 1e-13));
    ASSERT_TRUE(cross(point, position).isApprox(point.cross(position), 1e-13));
  }
}

}  // namespace
}  // namespace rmap::simulation
