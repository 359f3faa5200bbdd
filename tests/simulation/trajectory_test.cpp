#include "simulation/trajectory.hpp"

#include <gtest/gtest.h>

namespace rmap::simulation {
namespace {

Vector3d position(const TimedPose& pose) { return pose.map_from_body.translation(); }
Vector3d forward(const TimedPose& pose) { return pose.map_from_body.linear().col(0); }
Vector3d up(const TimedPose& pose) { return pose.map_from_body.linear().col(2); }

TEST(Trajectory, a_path_has_both_ends_and_even_steps) {
  const auto poses = along_path({{0, 0, 1}, {3, 0, 1}, {3, 3, 1}}, 7, 12);
  ASSERT_EQ(poses.size(), 7u);
  const Vector3d expected[] = {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}, {3, 0, 1},
                               {3, 1, 1}, {3, 2, 1}, {3, 3, 1}};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_LT((position(poses[i]) - expected[i]).norm(), 1e-14) << i;
    EXPECT_DOUBLE_EQ(poses[i].time, 2.0 * static_cast<double>(i));
    EXPECT_NO_THROW(check_pose(poses[i].map_from_body));
  }
  EXPECT_EQ(forward(poses[1]), Vector3d(1, 0, 0));
  EXPECT_EQ(forward(poses[5]), Vector3d(0, 1, 0));
}

TEST(Trajectory, one_pose_is_the_start) {
  EXPECT_EQ(position(along_path({{1, 2, 3}, {5, 5, 5}}, 1, 9).at(0)), Vector3d(1, 2, 3));
  EXPECT_EQ(position(around_loop({{1, 2, 3}, {5, 5, 5}}, 1, 9).at(0)), Vector3d(1, 2, 3));
}

TEST(Trajectory, poses_stay_level_on_a_slope) {
  for (const TimedPose& pose : along_path({{0, 0, 0}, {1, 2, 5}}, 5, 1)) {
    EXPECT_EQ(up(pose), Vector3d(0, 0, 1));
    EXPECT_NEAR(forward(pose).y(), 2 * forward(pose).x(), 1e-15);
  }
}

TEST(Trajectory, a_loop_closes_with_the_step_after_its_last_pose) {
  const auto poses = around_loop({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, 8, 16);
  ASSERT_EQ(poses.size(), 8u);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vector3d step = position(poses[(i + 1) % poses.size()]) - position(poses[i]);
    EXPECT_NEAR(step.norm(), 2, 1e-14);
    EXPECT_DOUBLE_EQ(poses[i].time, 2.0 * static_cast<double>(i));
  }
}

TEST(Trajectory, views_from_all_around_look_at_the_centre_from_everywhere) {
  const auto poses = all_around(4, 24);
  ASSERT_EQ(poses.size(), 24u);
  int octants = 0;
  for (const TimedPose& pose : poses) {
    EXPECT_NO_THROW(check_pose(pose.map_from_body));
    EXPECT_NEAR(position(pose).norm(), 4, 1e-14);
    EXPECT_LT((position(pose) + 4 * forward(pose)).norm(), 1e-14);
    EXPECT_GT(up(pose).z(), 0) << "the view is upright";
    const Vector3d at = position(pose);
    octants |= 1 << ((at.x() > 0 ? 1 : 0) + (at.y() > 0 ? 2 : 0) + (at.z() > 0 ? 4 : 0));
  }
  EXPECT_EQ(octants, 255);
}

}  // namespace
}  // namespace rmap::simulation
