#include "support/scans.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/pose.hpp>

namespace rmap {
namespace {

std::string refusal(const Pose& pose) {
  try {
    check_pose(pose);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
  return "accepted";
}

TEST(CheckPose, AcceptsRotationsOnly) {
  test::Random random(1);
  SCOPED_TRACE(random.trace());
  for (int i = 0; i < 200; ++i) EXPECT_EQ(refusal(test::random_pose(random, 100)), "accepted");
  Pose pose = Pose::Identity();
  pose.matrix()(0, 1) = 9e-4;
  EXPECT_EQ(refusal(pose), "accepted");
  pose.matrix()(0, 1) = 2e-3;
  EXPECT_THAT(refusal(pose), testing::HasSubstr("no rotation"));
  pose = Pose::Identity();
  pose.matrix()(2, 2) = -1;
  EXPECT_THAT(refusal(pose), testing::HasSubstr("reflection"));
  pose = Pose::Identity();
  pose.matrix()(1, 3) = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal(pose), testing::HasSubstr("not finite"));
  pose.matrix()(1, 3) = 0;
  pose.matrix()(1, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal(pose), testing::HasSubstr("not finite"));
}

TEST(MakePose, NormalisesQuaternionsOfAnyLength) {
  for (const double length : {1e-300, 1e-3, 1.0, 1e300}) {
    const Pose pose =
        make_pose({1, 2, 3}, Eigen::Quaterniond(length, 0, 0, length));  // 90 degrees about z
    EXPECT_NEAR((pose.linear() - Eigen::AngleAxisd(M_PI / 2, Vector3d::UnitZ()).matrix()).norm(), 0,
                1e-15);
    EXPECT_EQ(Vector3d(pose.translation()), Vector3d(1, 2, 3));
  }
  EXPECT_THROW(make_pose({0, 0, 0}, Eigen::Quaterniond(0, 0, 0, 0)), Error);
  EXPECT_THROW(make_pose({0, 0, 0}, Eigen::Quaterniond(std::nan(""), 0, 0, 1)), Error);
  EXPECT_THROW(make_pose({0, std::nan(""), 0}, Eigen::Quaterniond(1, 0, 0, 0)), Error);
}

TEST(Transformed, RoundsEachOperationOnce) {
  test::Random random(2);
  SCOPED_TRACE(random.trace());
  for (int i = 0; i < 5000; ++i) {
    const Pose pose = test::random_pose(random, 50);
    const Vector3f point = random.point(-80, 80).cast<float>();
    const Vector3d moved = transformed(pose, point);
    for (int row = 0; row < 3; ++row) {
      volatile double sum = pose(row, 0) * static_cast<double>(point.x());
      volatile double term = pose(row, 1) * static_cast<double>(point.y());
      sum = sum + term;
      term = pose(row, 2) * static_cast<double>(point.z());
      sum = sum + term;
      sum = sum + pose(row, 3);
      ASSERT_EQ(moved[row], sum);
    }
    ASSERT_NEAR((rotated(pose, point) - (moved - pose.translation())).norm(), 0, 1e-9);
  }
}

}  // namespace
}  // namespace rmap
