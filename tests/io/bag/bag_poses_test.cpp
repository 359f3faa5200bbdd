// Which poses the clouds of a bag get, and what is said when there are none.
#include "io/bag/bag_samples.hpp"
#include "io/files.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::add_cloud;
using test::add_transform;
using test::expect_error;
using test::kSecond;
using test::kStart;
using test::scans_of;
using test::TestBag;
using testing::HasSubstr;

class BagPosesTest : public testing::Test {
 protected:
  std::string write(const TestBag& bag) {
    const auto file = folder_ / "a.mcap";
    test::write_text(file, test::mcap_bytes(bag));
    return file;
  }
  std::string sentence_of(const TestBag& bag, const ScanReadOptions& options = {}) {
    try {
      open_scans(write(bag), options);
      return "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      return error.what();
    }
  }
  const test::TemporaryFolder& folder() const { return folder_; }

 private:
  test::TemporaryFolder folder_;
};

// Drops the topics with these names.
TestBag without(TestBag bag, const std::vector<std::string>& names) {
  std::erase_if(bag.messages, [&](const test::TestMessage& message) {
    return std::find(names.begin(), names.end(), bag.topics[message.topic].name) != names.end();
  });
  for (test::TestTopic& topic : bag.topics) {
    if (std::find(names.begin(), names.end(), topic.name) != names.end()) topic.type = "x/msg/Y";
  }
  return bag;
}

TEST_F(BagPosesTest, come_from_transforms_odometry_or_a_file_alike) {
  const std::string bag = write(test::driving_bag(3));
  const std::vector<test::ReadScan> expected = {{0, 0}, {1, 1}, {2, 2}};
  EXPECT_EQ(scans_of(bag), expected);
  EXPECT_EQ(scans_of(bag, {.bag = {.pose_topic = "/odom"}}), expected);
  test::write_text(folder() / "t.txt",
                   "1700000000 5 0 0 0 0 0 1\n1700000001.0 6 0 0 0 0 0 1\n"
                   "1700000002 7 0 0 0 0 0 1\n");
  const std::vector<test::ReadScan> shifted = {{0, 5}, {1, 6}, {2, 7}};
  EXPECT_EQ(scans_of(bag, {.trajectory = folder() / "t.txt"}), shifted);
  EXPECT_EQ(scans_of(bag, {.offset = {-5, 0, 0}}), shifted);
}

TEST_F(BagPosesTest, of_odometry_are_carried_on_to_the_sensor) {
  for (const bool transforms : {false, true}) {
    const auto bag = transforms ? test::driving_bag(2) : without(test::driving_bag(2), {"/tf"});
    const auto source = open_scans(write(bag), {.bag = {.pose_topic = "/odom"}});
    Scan scan;
    ASSERT_TRUE(source->next(scan));
    EXPECT_EQ(scan.map_from_sensor.translation(), Vector3d(0, 0, 0.5));
  }
}

TEST_F(BagPosesTest, of_plain_pose_topics_are_the_sensors) {
  TestBag bag;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t stamp = kStart + i * kSecond;
    const test::TestTransform pose{
        .stamp = stamp, .parent = "map", .child = "", .translation = {2.0 * i, 0, 0}};
    bag.add("/pose", test::kPoseType, stamp, test::pose_message(pose));
    bag.add("/fused", test::kCovarianceType, stamp, test::pose_with_covariance_message(pose));
    add_cloud(bag, stamp, static_cast<float>(i));
  }
  const std::vector<test::ReadScan> expected = {{0, 0}, {1, 2}, {2, 4}};
  EXPECT_EQ(scans_of(write(bag), {.bag = {.pose_topic = "/pose"}}), expected);
  EXPECT_EQ(scans_of(write(bag), {.bag = {.pose_topic = "/fused"}}), expected);
  EXPECT_EQ(scans_of(write(without(bag, {"/fused"}))), expected);
  EXPECT_THAT(sentence_of(bag),
              HasSubstr("no transforms that move lead to the frame \"lidar\" of the clouds of "
                        "/points, and there are several topics of poses, /fused "
                        "(geometry_msgs/msg/PoseWithCovarianceStamped), /pose "
                        "(geometry_msgs/msg/PoseStamped): choose one (--pose-topic)"));
  EXPECT_THAT(sentence_of(bag, {.bag = {.pose_topic = "/pose", .map_frame = "earth"}}),
              HasSubstr("the poses of /pose are in the frame \"map\", and the map must be in "
                        "\"earth\" (--map-frame)"));
}

TEST_F(BagPosesTest, are_missing_outside_of_their_span) {
  TestBag bag = test::driving_bag(3);
  add_cloud(bag, kStart + 5 * kSecond / 2, 7);
  add_cloud(bag, kStart + kSecond / 2, 8);
  const auto source = open_scans(write(bag));
  EXPECT_EQ(source->size(), 4u);
  EXPECT_EQ(source->notes().without_pose, 1u);
  EXPECT_EQ(scans_of(write(bag)), (std::vector<test::ReadScan>{{0, 0}, {8, 0.5}, {1, 1}, {2, 2}}));
}

TEST_F(BagPosesTest, that_cover_no_cloud_at_all_are_an_error) {
  TestBag bag;
  add_transform(bag, kStart, "map", "lidar", {0, 0, 0});
  add_cloud(bag, kStart + 1, 7);
  EXPECT_THAT(sentence_of(bag),
              HasSubstr("none of the 1 clouds of /points has a pose: the last of them is of "
                        "1700000000.000000001 s, and the transforms from map does not cover it"));
}

TEST_F(BagPosesTest, lead_to_the_frame_that_is_chosen) {
  TestBag bag = test::driving_bag(3);
  for (const int i : {0, 2}) {
    add_transform(bag, kStart + i * kSecond, "map", "odom", {100, 0, 0});
  }
  EXPECT_EQ(scans_of(write(bag)).at(1).place, 101);
  EXPECT_EQ(scans_of(write(bag), {.bag = {.map_frame = "odom"}}).at(1).place, 1);
  // All scans would lie on one another.
  EXPECT_THAT(
      sentence_of(bag, {.bag = {.map_frame = "base"}}),
      HasSubstr("no transform between the frame \"base\" of the map (--map-frame) and the "
                "clouds of /points moves: it is on the robot itself; they hang in \"map\""));
  EXPECT_THAT(sentence_of(bag, {.bag = {.map_frame = "earth"}}),
              HasSubstr("no transform in it names the frame \"earth\" of the map (--map-frame)"));
}

TEST_F(BagPosesTest, that_are_missing_are_asked_for) {
  const TestBag bag = without(test::driving_bag(2), {"/tf", "/tf_static", "/odom"});
  EXPECT_THAT(sentence_of(bag), HasSubstr("poses in a file (--trajectory) are needed"));
  EXPECT_THAT(sentence_of(bag, {.bag = {.pose_topic = "/none"}}),
              HasSubstr("there is no topic \"/none\" of poses"));
  EXPECT_THAT(sentence_of(without(test::driving_bag(2), {"/tf", "/tf_static"})),
              HasSubstr("the poses of /odom are of the frame \"base\", and no transforms lead from "
                        "it to the frame \"lidar\""));
}

TEST_F(BagPosesTest, of_broken_transforms_are_an_error_where_they_are_used) {
  TestBag bag = test::driving_bag(2);
  add_transform(bag, kStart, "mast", "lidar", {0, 0, 0}, "/tf_static");
  EXPECT_THAT(sentence_of(bag),
              HasSubstr("a.mcap, message 2 of /tf_static: the frame \"lidar\" has two parents, "
                        "\"base\" and \"mast\""));
  test::write_text(folder() / "t.txt", "1700000000 0 0 0 0 0 0 1\n1700000001 1 0 0 0 0 0 1\n");
  EXPECT_EQ(scans_of(write(bag), {.trajectory = folder() / "t.txt"}).size(), 2u);
}

}  // namespace
}  // namespace rmap
