#include "io/bag/bag_source.hpp"

#include "io/bag/bag_samples.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::add_cloud;
using test::expect_error;
using test::kSecond;
using test::kStart;
using test::scans_of;
using test::TestBag;
using testing::HasSubstr;

std::string write(const test::TemporaryFolder& folder, const TestBag& bag) {
  test::write_text(folder / "a.mcap", test::mcap_bytes(bag));
  return folder / "a.mcap";
}

TEST(BagSource, gives_whole_scans_and_rewinds) {
  const test::TemporaryFolder folder;
  const std::string file = write(folder, test::driving_bag(2));
  const auto source = open_scans(file);
  EXPECT_EQ(source->size(), 2u);
  for (int pass = 0; pass < 2; ++pass) {
    Scan scan{
        .frame = Frame::map, .origins = {{1, 1, 1}}, .no_returns = {{1, 1, 1}}, .sensor_range = 5};
    ASSERT_TRUE(source->next(scan));
    EXPECT_EQ(scan.frame, Frame::sensor);
    EXPECT_TRUE(scan.origins.empty());
    EXPECT_TRUE(scan.no_returns.empty());
    EXPECT_EQ(scan.sensor_range, std::numeric_limits<double>::infinity());
    EXPECT_EQ(scan.name, file + ", message 1 of /points");
    ASSERT_TRUE(source->next(scan));
    EXPECT_FALSE(source->next(scan));
    EXPECT_FALSE(source->next(scan));
    source->rewind();
  }
}

TEST(BagSource, takes_the_topic_that_is_chosen) {
  const test::TemporaryFolder folder;
  TestBag bag = test::driving_bag(2);
  add_cloud(bag, kStart, 9, "/rear");
  const std::string file = write(folder, bag);
  EXPECT_EQ(scans_of(file, {.bag = {.topic = "/rear"}}), (std::vector<test::ReadScan>{{9, 0}}));
  expect_error(ErrorKind::input,
               file +
                   ": there are several topics of clouds in it, /points "
                   "(sensor_msgs/msg/PointCloud2), /rear (sensor_msgs/msg/PointCloud2): choose "
                   "one (--topic)",
               [&] { open_scans(file); });
  expect_error(ErrorKind::input,
               file +
                   ": there is no topic \"/front\" in it: its topics are /odom "
                   "(nav_msgs/msg/Odometry), /points (sensor_msgs/msg/PointCloud2), /rear "
                   "(sensor_msgs/msg/PointCloud2), /tf (tf2_msgs/msg/TFMessage), /tf_static "
                   "(tf2_msgs/msg/TFMessage)",
               [&] { open_scans(file, {.bag = {.topic = "/front"}}); });
  expect_error(ErrorKind::input,
               file +
                   ": the topic /tf is of type \"tf2_msgs/msg/TFMessage\", where "
                   "sensor_msgs/PointCloud2 is allowed",
               [&] { open_scans(file, {.bag = {.topic = "/tf"}}); });
}

TEST(BagSource, takes_clouds_that_are_in_the_map) {
  const test::TemporaryFolder folder;
  TestBag bag;
  // Odometry of a frame that nothing links to the clouds, which name the map's.
  for (int i = 0; i < 2; ++i) {
    const std::int64_t stamp = kStart + i * kSecond;
    bag.add(
        "/odom", test::kOdometryType, stamp,
        test::odometry_message(
            {.stamp = stamp, .parent = "map", .child = "body", .translation = {100.0 + i, 0, 0}}));
    add_cloud(bag, stamp, 105, "/registered", "map");
  }
  const std::string file = write(folder, bag);
  EXPECT_EQ(scans_of(file, {.frame = Frame::map, .offset = {100, 0, 0}}),
            (std::vector<test::ReadScan>{{5, 0}, {5, 1}}));
  const auto source = open_scans(file, {.frame = Frame::map});
  Scan scan;
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.frame, Frame::map);
  EXPECT_THROW(open_scans(file), Error);
}

TEST(BagSource, takes_a_part_of_the_time) {
  const test::TemporaryFolder folder;
  const std::string file = write(folder, test::driving_bag(6));
  EXPECT_EQ(scans_of(file, {.bag = {.from = 1, .to = 3}}),
            (std::vector<test::ReadScan>{{1, 1}, {2, 2}, {3, 3}}));
  EXPECT_EQ(scans_of(file, {.bag = {.from = 4.5}}), (std::vector<test::ReadScan>{{5, 5}}));
  expect_error(ErrorKind::usage,
               "from (--from) is 2 and to (--to) 1: from must not be the later one",
               [&] { open_scans(file, {.bag = {.from = 2, .to = 1}}); });
}

TEST(BagSource, goes_on_behind_a_bad_cloud) {
  const test::TemporaryFolder folder;
  // Within the header, and within the points.
  for (const std::size_t cut : {2, 60}) {
    TestBag bag = test::driving_bag(3);
    for (test::TestMessage& message : bag.messages) {
      const bool second =
          bag.topics[message.topic].name == "/points" && message.recorded == kStart + kSecond;
      if (second) message.data.resize(cut);
    }
    const std::string file = write(folder, bag);
    const auto source = open_scans(file);
    Scan scan;
    ASSERT_TRUE(source->next(scan));
    try {
      source->next(scan);
      FAIL();
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(file + ", message 2 of /points: "));
    }
    ASSERT_TRUE(source->next(scan));
    EXPECT_EQ(scan.points.at(0).x(), 2);
    EXPECT_FALSE(source->next(scan));
  }
}

TEST(BagSource, refuses_options_without_meaning) {
  const test::TemporaryFolder folder;
  const std::string file = write(folder, test::driving_bag(1));
  const std::vector<ScanReadOptions> all = {{.sensor_pose = Pose::Identity()},
                                            {.sensor_origin = Vector3d(0, 0, 0)},
                                            {.end_points = true},
                                            {.columns = {"x"}},
                                            {.times = "t"},
                                            {.trajectory = "t", .bag = {.pose_topic = "/odom"}},
                                            {.trajectory = "t", .bag = {.map_frame = "map"}}};
  for (const ScanReadOptions& options : all) {
    try {
      open_scans(file, options);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::usage);
      EXPECT_THAT(error.what(), HasSubstr(" has no meaning for " + file));
    }
  }
  EXPECT_EQ(all.size(), 7u);
  EXPECT_EQ(scans_of(file, {.frame = Frame::sensor}).size(), 1u);
}

TEST(BagSource, refuses_encodings_of_others) {
  const test::TemporaryFolder folder;
  TestBag bag = test::driving_bag(1);
  for (test::TestTopic& topic : bag.topics) topic.encoding = "ros1";
  expect_error(ErrorKind::input,
               write(folder, bag) +
                   ": the messages of /points are encoded as \"ros1\", where cdr, "
                   "that of ROS 2, is allowed: rosbags-convert makes a bag of ROS "
                   "2 of one of ROS 1",
               [&] { open_scans(folder / "a.mcap"); });
  test::write_text(folder / "b.bag", "#ROSBAG V2.0\n");
  EXPECT_THROW(open_scans(folder / "b.bag"), Error);
}

}  // namespace
}  // namespace rmap
