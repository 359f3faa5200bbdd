#include "io/files.hpp"
#include "support/random.hpp"

#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;

std::vector<Pose> read_text_as_poses(const std::string& text) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "poses.txt", text);
  return read_poses(folder / "poses.txt");
}

Pose random_pose(test::Random& random) {
  const Vector3d axis = random.direction();
  return make_pose(random.point(-1e6, 1e6),
                   Eigen::Quaterniond(Eigen::AngleAxisd(random.real(-3, 3), axis)));
}

// x goes to y, y to -x.
const std::string kQuarterTurn = "0 -1 0 5 1 0 0 6 0 0 1 7";

void expect_quarter_turn(const Pose& pose) {
  EXPECT_TRUE(transformed(pose, {1, 0, 0}).isApprox(Vector3d(5, 7, 7), 1e-15));
  EXPECT_TRUE(transformed(pose, {0, 1, 0}).isApprox(Vector3d(4, 6, 7), 1e-15));
  EXPECT_EQ(pose.translation(), Vector3d(5, 6, 7));
}

TEST(PoseFile, reads_each_form) {
  const std::vector<std::string> forms = {kQuarterTurn, kQuarterTurn + " 0 0 0 1",
                                          "5 6 7 0 0 0.70710678118654757 0.70710678118654757",
                                          "1403636579.763555527 5 6 7 0 0 2 2"};
  for (const std::string& form : forms) {
    SCOPED_TRACE(form);
    const auto poses = read_text_as_poses(fmt::format("{0}\n{0}\n", form));
    ASSERT_EQ(poses.size(), 2u);
    expect_quarter_turn(poses[0]);
    expect_quarter_turn(poses[1]);
  }
}

TEST(PoseFile, passes_over_comments_and_blank_lines) {
  const auto poses = read_text_as_poses("# tx ty tz ...\n\n  \t\r\n" + kQuarterTurn +
                                        " # the first\n#\n  +0 -1 0 5.0\t1" + " 0 0 6e0 0 0 1 7");
  ASSERT_EQ(poses.size(), 2u);
  expect_quarter_turn(poses[1]);
  EXPECT_TRUE(read_text_as_poses("").empty());
  EXPECT_TRUE(read_text_as_poses("# nothing\n").empty());
}

TEST(PoseFile, keeps_the_numbers_of_a_matrix) {
  // Within the tolerance of check_pose, and not made orthonormal.
  const auto poses = read_text_as_poses("1.0001 0 0 0 0 1 0 0 0 0 1 0\n");
  ASSERT_EQ(poses.size(), 1u);
  EXPECT_EQ(poses[0](0, 0), 1.0001);
}

TEST(PoseFile, gives_back_the_poses_that_were_written) {
  test::Random random(8);
  SCOPED_TRACE(random.trace());
  std::vector<Pose> poses = {Pose::Identity()};
  for (int i = 0; i < 500; ++i) poses.push_back(random_pose(random));
  const test::TemporaryFolder folder;
  write_poses(folder / "poses.txt", poses);
  const auto read = read_poses(folder / "poses.txt");
  ASSERT_EQ(read.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ASSERT_EQ(read[i].matrix(), poses[i].matrix()) << i;
  }
  write_poses(folder / "poses.txt", {});
  EXPECT_TRUE(read_poses(folder / "poses.txt").empty());
}

struct BadPose {
  std::string line;
  std::string problem;
};

TEST(PoseFile, names_line_and_problem) {
  const std::vector<BadPose> cases = {
      {"1 2 3",
       "the pose has 3 numbers, where 12 (3x4 matrix), 16 (4x4 matrix), 7 (tx ty tz qx qy qz qw) "
       "and 8 (time, then these 7) are allowed"},
      {kQuarterTurn + " 0 0 0 1 0",
       "the pose has 17 numbers, where 12 (3x4 matrix), 16 (4x4 matrix), 7 (tx ty tz qx qy qz qw) "
       "and 8 (time, then these 7) are allowed"},
      {"0 0 0 0 0 0 1", "the pose has 7 numbers, which must be 12 as in the lines before"},
      {"0 -1 0 5 1 0 0 6 0 0 1 seven", "\"seven\" is no number, which a pose is made of"},
      {"0;-1;0;5", "\"0;-1;0;5\" is no number, which a pose is made of"},
      {"0 -1 0 5 1 0 0 6 0 0 1 1e999", "\"1e999\" is no number, which a pose is made of"},
      {"0 -1 0 nan 1 0 0 6 0 0 1 7", "the pose holds a number that is not finite"},
      {"0 -1 0 5 1 0 0 6 0 0 -1 7",
       "the 3x3 part of the pose is no rotation but a reflection: its determinant is -1"}};
  const test::TemporaryFolder folder;
  const std::string file = folder / "poses.txt";
  for (const BadPose& bad : cases) {
    test::write_text(file, "# comment\n" + kQuarterTurn + "\n" + bad.line + "\n");
    expect_error(ErrorKind::input, fmt::format("{}, line 3: {}", file, bad.problem),
                 [&] { read_poses(file); });
  }
  EXPECT_EQ(cases.size(), 8u);
}

TEST(PoseFile, refuses_what_is_no_rigid_transform) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "poses.txt";
  const std::vector<BadPose> cases = {
      {"2 0 0 0 0 1 0 0 0 0 1 0",
       "the 3x3 part of the pose is no rotation: it is 3 away from orthonormal, 0.001 is allowed"},
      {"1 2 3 0 0 0 0", "the quaternion of the pose is zero: it must have a length"},
      {"9.5 1 2 3 0 0 0 -0", "the quaternion of the pose is zero: it must have a length"},
      {"1 2 3 inf 0 0 1", "the pose holds a number that is not finite"},
      {kQuarterTurn + " 0 0 0 2",
       "the last row of the 4x4 matrix is 0 0 0 2, which must be 0 0 0 1"},
      {kQuarterTurn + " 5 6 7 1",
       "the last row of the 4x4 matrix is 5 6 7 1, which must be 0 0 0 1"},
      {kQuarterTurn + " 0 nan 0 1",
       "the last row of the 4x4 matrix is 0 nan 0 1, which must be 0 0 0 1"}};
  for (const BadPose& bad : cases) {
    test::write_text(file, bad.line);
    expect_error(ErrorKind::input, fmt::format("{}, line 1: {}", file, bad.problem),
                 [&] { read_poses(file); });
  }
  EXPECT_EQ(cases.size(), 7u);
}

TEST(PoseFile, says_when_the_file_is_missing) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "poses.txt";
  expect_error(ErrorKind::io, "cannot open " + file + ": No such file or directory",
               [&] { read_poses(file); });
}

}  // namespace
}  // namespace rmap
