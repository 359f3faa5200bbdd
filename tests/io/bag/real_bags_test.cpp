// Bags that others made, as they are.
#include "io/bag/bag_samples.hpp"
#include "io/files.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/bag_info.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using testing::HasSubstr;

// The bag must give these scans of the sequence, whose poses have no more than 1e-9 between.
void expect_scans(const std::filesystem::path& bag, const std::vector<std::size_t>& numbers,
                  const ScanReadOptions& options) {
  SCOPED_TRACE(bag);
  const auto folder = test::real_data("sequences/stationary_outdoor");
  std::vector<Scan> sequence;
  for (const Scan& scan : read_scans(folder)) sequence.push_back(scan);
  const auto source = open_scans(bag, options);
  EXPECT_EQ(source->size(), numbers.size());
  Scan scan;
  for (const std::size_t number : numbers) {
    ASSERT_TRUE(source->next(scan));
    const Scan& expected = sequence.at(number);
    EXPECT_TRUE(test::same_bits(scan.points, expected.points));
    EXPECT_LT(
        (scan.map_from_sensor.matrix() - expected.map_from_sensor.matrix()).cwiseAbs().maxCoeff(),
        1e-9);
  }
  EXPECT_FALSE(source->next(scan));
  EXPECT_EQ(source->notes().without_pose, 0u);
}

TEST(RealBags, hold_the_scans_of_their_sequence) {
  const auto bags = test::real_data("bags");
  if (bags.empty()) GTEST_SKIP() << "the real data are missing: RMAP_DATA names their folder";
  for (const char* poses : {"", "/odom"}) {
    const ScanReadOptions options{.bag = {.pose_topic = poses}};
    // By their place in the sequence: it holds every third scan, and so do the bags.
    expect_scans(bags / "outdoor_db3", {0, 3}, options);
    expect_scans(bags / "outdoor_mcap_zstd", {0, 3}, options);
    expect_scans(bags / "outdoor_mcap_plain", {1}, options);
    expect_scans(bags / "outdoor_db3/outdoor_db3_0.db3", {0, 3}, options);
  }
}

TEST(RealBags, of_a_robot_without_clouds_tell_so) {
  const auto bag = test::real_data("bags/nav2_turtlebot.mcap");
  if (bag.empty()) GTEST_SKIP() << "the real data are missing: RMAP_DATA names their folder";
  const BagInfo info = read_bag_info(bag);
  EXPECT_EQ(info.messages, 8197u);
  ASSERT_EQ(info.topics.size(), 4u);
  EXPECT_EQ(info.topics[0].name, "/amcl_pose");
  EXPECT_EQ(info.topics[0].messages, 135u);
  EXPECT_EQ(info.topics[1].messages, 2639u);
  EXPECT_EQ(info.topics[2].messages, 5422u);
  EXPECT_EQ(info.topics[3].messages, 1u);
  EXPECT_EQ(info.frames_problem, "");
  const auto odom = std::find_if(info.frames.begin(), info.frames.end(),
                                 [](const auto& frame) { return frame.name == "odom"; });
  ASSERT_NE(odom, info.frames.end());
  EXPECT_EQ(odom->parent, "map");
  EXPECT_TRUE(odom->moves);
  try {
    open_scans(bag);
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("there are no clouds (sensor_msgs/PointCloud2) in it"));
  }
}

}  // namespace
}  // namespace rmap
