#include "io/trajectory.hpp"

#include "io/files.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::expect_error;
using test::write_text;

TimedPose at_x(std::int64_t stamp, double x) {
  return {.stamp = stamp, .pose = make_pose({x, 0, 0}, {1, 2, 3, 4})};
}

TEST(Trajectory, gives_poses_at_their_stamps_as_they_are) {
  const Trajectory trajectory({at_x(30, 3), at_x(10, 1), at_x(20, 2)});
  for (const auto& [stamp, pose] : trajectory.poses()) {
    EXPECT_EQ(trajectory.at(stamp)->matrix(), pose.matrix());
  }
  EXPECT_DOUBLE_EQ(trajectory.at(15)->translation().x(), 1.5);
  EXPECT_DOUBLE_EQ(trajectory.at(29)->translation().x(), 2.9);
}

TEST(Trajectory, knows_nothing_outside_of_its_span) {
  const Trajectory trajectory({at_x(10, 1), at_x(30, 3)});
  EXPECT_FALSE(trajectory.at(9));
  EXPECT_FALSE(trajectory.at(31));
  EXPECT_FALSE(Trajectory().at(0));
  EXPECT_TRUE(Trajectory({at_x(10, 1)}).at(10));
}

TEST(Trajectory, keeps_the_last_of_equal_stamps) {
  const Trajectory trajectory({at_x(10, 1), at_x(20, 2), at_x(10, 5)});
  EXPECT_EQ(trajectory.poses().size(), 2u);
  EXPECT_EQ(trajectory.at(10)->translation().x(), 5);
}

TEST(Trajectory, spans_all_of_time) {
  using Limits = std::numeric_limits<std::int64_t>;
  const Trajectory trajectory({at_x(Limits::min(), 0), at_x(Limits::max(), 1)});
  EXPECT_NEAR(trajectory.at(0)->translation().x(), 0.5, 1e-12);
}

TEST(TrajectoryFile, holds_tum_lines) {
  const test::TemporaryFolder folder;
  write_text(folder / "t.txt",
             "# time x y z qx qy qz qw\n1690309709.284305601 1 2 3 0 0 0 1\n\n"
             "1690309710.5 4 5 6 1 0 0 0 # last\n");
  const Trajectory trajectory = read_trajectory(folder / "t.txt");
  ASSERT_EQ(trajectory.poses().size(), 2u);
  EXPECT_EQ(trajectory.poses()[0].stamp, 1690309709284305601);
  EXPECT_EQ(trajectory.poses()[1].pose.translation(), Vector3d(4, 5, 6));
  EXPECT_EQ(trajectory.poses()[1].pose(1, 1), -1);
}

TEST(TrajectoryFile, holds_kitti_lines_with_times_beside_them) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "poses.txt";
  const std::string times = folder / "times.txt";
  write_text(file, "1 0 0 7 0 1 0 8 0 0 1 9\n1 0 0 1 0 1 0 2 0 0 1 3\n");
  write_text(times, "0.000000e+00\n1.036224e-01\n");
  const Trajectory trajectory = read_trajectory(file, times);
  EXPECT_EQ(trajectory.at(103622400)->translation(), Vector3d(1, 2, 3));
  expect_error(ErrorKind::usage,
               "the poses of " + file +
                   " have no times: a file with a time for each is needed beside it (--times)",
               [&] { read_trajectory(file); });
  write_text(times, "0\n");
  expect_error(
      ErrorKind::input,
      times + " holds 1 times and " + file + " holds 2 poses: there must be one time for each pose",
      [&] { read_trajectory(file, times); });
  write_text(times, "0\n1 2\n");
  expect_error(ErrorKind::input,
               times + ", line 2: the line has 2 words, where one time is allowed",
               [&] { read_trajectory(file, times); });
}

TEST(TrajectoryFile, refuses_what_it_cannot_be) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "t.txt";
  const auto expect = [&](const std::string& text, const std::string& sentence) {
    write_text(file, text);
    expect_error(ErrorKind::input, file + sentence, [&] { read_trajectory(file); });
  };
  expect("", " holds no pose: at least one is needed");
  expect(
      "1 2 3\n",
      ", line 1: the pose has 3 numbers, where 8 (TUM: time tx ty tz qx qy qz qw) and 12 (KITTI: "
      "3x4 matrix) are allowed");
  expect("0 1 2 3 0 0 0 1\n1 0 0 7 0 1 0 8 0 0 1 9\n",
         ", line 2: the pose has 12 numbers, which must be 8 as in the lines before");
  expect("0 1 2 3 0 0 0 0\n",
         ", line 1: the quaternion of the pose is zero: it must have a length");
  expect("1e99 1 2 3 0 0 0 1\n",
         ", line 1: \"1e99\" is no time: seconds as a decimal number, within +-9.2e9, are allowed");
  expect("0 1 2 x 0 0 0 1\n", ", line 1: \"x\" is no number, which a pose is made of");
}

TEST(Trajectory, knows_the_order_of_quaternions_by_the_argument) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "t.txt", "1 0 0 0 0 0 0 1\n");
  const auto turned = [&](QuaternionOrder order) {
    const Pose pose = read_trajectory(folder / "t.txt", {}, order).poses().at(0).pose;
    return rotated(pose, {1, 0, 0});
  };
  EXPECT_EQ(turned(QuaternionOrder::xyzw), Vector3d(1, 0, 0));
  EXPECT_EQ(turned(QuaternionOrder::wxyz), Vector3d(-1, 0, 0));
}

}  // namespace
}  // namespace rmap
