#include "io/bag/frame_tree.hpp"

#include "io/files.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::expect_error;

StampedPose link(std::int64_t stamp, const std::string& parent, const std::string& child, double x,
                 double degrees = 0) {
  const double half = degrees * std::acos(-1.0) / 360;
  return {.header = {.stamp = stamp, .frame = parent},
          .child = child,
          .pose = make_pose({x, 0, 0}, {std::cos(half), 0, 0, std::sin(half)})};
}

TEST(FrameTree, chains_links_of_different_rates) {
  FrameTree tree;
  tree.add(link(0, "map", "odom", 100), false);
  tree.add(link(100, "map", "odom", 200), false);
  for (int i = 0; i <= 100; i += 10) tree.add(link(i, "odom", "base", i), false);
  tree.add(link(0, "base", "lidar", 0.5), true);
  tree.finish();
  EXPECT_EQ(tree.root_of("lidar"), "map");
  const FrameChain chain(tree, "map", "lidar");
  EXPECT_TRUE(chain.moves());
  EXPECT_NEAR(chain.at(35)->translation().x(), 135 + 35 + 0.5, 1e-12);
  EXPECT_FALSE(chain.at(101));
  EXPECT_FALSE(FrameChain(tree, "base", "lidar").moves());
  EXPECT_EQ(FrameChain(tree, "base", "lidar").at(1000)->translation().x(), 0.5);
  EXPECT_EQ(FrameChain(tree, "lidar", "lidar").at(7)->matrix(), Pose::Identity().matrix());
}

TEST(FrameTree, goes_up_and_down_again) {
  FrameTree tree;
  tree.add(link(0, "base", "lidar", 2), true);
  tree.add(link(0, "base", "odom", 1, 90), true);
  tree.finish();
  const Pose pose = *FrameChain(tree, "odom", "lidar").at(0);
  EXPECT_NEAR(pose.translation().x(), 0, 1e-15);
  EXPECT_NEAR(pose.translation().y(), -1, 1e-15);
}

TEST(FrameTree, gives_a_single_link_as_it_is) {
  FrameTree tree;
  const StampedPose only = link(5, "map", "lidar", 0.1, 33);
  tree.add(only, false);
  tree.finish();
  EXPECT_EQ(FrameChain(tree, "map", "lidar").at(5)->matrix(), only.pose.matrix());
}

TEST(FrameTree, refuses_two_parents_circles_and_strangers) {
  FrameTree tree;
  tree.add(link(0, "base", "lidar", 1), true);
  expect_error(ErrorKind::input,
               "the frame \"lidar\" has two parents, \"base\" and \"mast\", where one is allowed",
               [&] { tree.add(link(0, "mast", "lidar", 1), true); });
  expect_error(ErrorKind::input, "the frame \"a\" hangs in itself, and must hang in another one",
               [&] { tree.add(link(0, "a", "a", 1), true); });
  tree.finish();
  expect_error(ErrorKind::input, "no transforms connect the frames \"map\" and \"lidar\"",
               [&] { FrameChain(tree, "map", "lidar"); });
  FrameTree circle;
  circle.add(link(0, "a", "b", 1), true);
  circle.add(link(0, "b", "c", 1), true);
  circle.add(link(0, "c", "a", 1), true);
  expect_error(ErrorKind::input, "the frames above \"a\" hang in a circle: \"a\" comes twice",
               [&] { circle.finish(); });
}

TEST(FrameTree, bears_a_very_long_chain) {
  FrameTree tree;
  for (int i = 0; i < 20'000; ++i) {
    tree.add(link(0, fmt::format("f{}", i + 1), fmt::format("f{}", i), 1), true);
  }
  tree.finish();
  expect_error(ErrorKind::limit, "more than 1000 frames hang in one another above \"f0\"",
               [&] { tree.root_of("f0"); });
}

}  // namespace
}  // namespace rmap
