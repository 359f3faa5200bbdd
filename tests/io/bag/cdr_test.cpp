#include "io/bag/cdr.hpp"

#include "io/bag/pose_messages.hpp"
#include "io/files.hpp"
#include "support/bag_messages.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CdrWriter;
using test::expect_error;

std::span<const std::byte> bytes(const std::string& text) { return std::as_bytes(std::span(text)); }

TEST(Cdr, reads_both_byte_orders_with_their_gaps) {
  for (const bool big : {false, true}) {
    CdrWriter writer(big);
    writer.number(std::uint8_t{7}).number(2.5).number(std::uint8_t{1}).text("ab").number(-3);
    CdrReader reader(bytes(writer.bytes()));
    EXPECT_EQ(reader.number<std::uint8_t>("a"), 7);
    EXPECT_EQ(reader.number<double>("b"), 2.5);
    EXPECT_EQ(reader.number<std::uint8_t>("c"), 1);
    EXPECT_EQ(reader.text("d"), "ab");
    EXPECT_EQ(reader.number<std::int32_t>("e"), -3);
  }
}

TEST(Cdr, of_version_2_aligns_to_4_at_most) {
  std::string message("\0\7\0\0\1\0\0\0", 8);
  message += test::raw(2.5);
  CdrReader reader(bytes(message));
  EXPECT_EQ(reader.number<std::uint32_t>("a"), 1U);
  EXPECT_EQ(reader.number<double>("b"), 2.5);
}

TEST(Cdr, says_what_is_cut_off) {
  expect_error(ErrorKind::input, "its header at byte 0 takes 4 bytes, and 3 are left",
               [] { CdrReader reader(bytes("abc")); });
  expect_error(ErrorKind::input,
               "it begins with 61 62, where plain CDR begins with 00 and one of 00, 01, 06, 07",
               [] { CdrReader reader(bytes("abcd")); });
  const std::string huge = std::string("\0\1\0\0", 4) + std::string(4, '\xff') + "abc";
  expect_error(ErrorKind::input, "a name at byte 8 takes 4294967295 bytes, and 3 are left",
               [&] { CdrReader(bytes(huge)).text("a name"); });
  expect_error(ErrorKind::input,
               "fields at byte 4 are 4294967295, which take at least 42949672950 bytes, and 3 are "
               "left",
               [&] { CdrReader(bytes(huge)).count(10, "fields"); });
  const std::string open = std::string("\0\1\0\0\2\0\0\0", 8) + "ab";
  expect_error(ErrorKind::input, "a name is \"ab\", and must end with a zero",
               [&] { CdrReader(bytes(open)).text("a name"); });
}

TEST(PoseMessages, are_read_in_both_byte_orders) {
  const test::TestTransform transform{.stamp = 5'000'000'007,
                                      .parent = "/odom",
                                      .child = "base",
                                      .translation = {1, 2, 3},
                                      .rotation = {0.5, 0.5, 0.5, 0.5}};
  const Pose expected = make_pose(transform.translation, transform.rotation);
  for (const bool big : {false, true}) {
    const auto transforms =
        decode_transforms(bytes(test::transforms_message({transform, transform}, big)));
    ASSERT_EQ(transforms.size(), 2u);
    EXPECT_EQ(transforms[1].header.stamp, transform.stamp);
    EXPECT_EQ(transforms[1].header.frame, "odom");
    EXPECT_EQ(transforms[1].child, "base");
    EXPECT_EQ(transforms[1].pose.matrix(), expected.matrix());
    const auto odometry =
        decode_pose(MessageType::odometry, bytes(test::odometry_message(transform, big)));
    EXPECT_EQ(odometry.child, "base");
    EXPECT_EQ(odometry.pose.matrix(), expected.matrix());
    const auto pose = decode_pose(MessageType::pose, bytes(test::pose_message(transform, big)));
    EXPECT_EQ(pose.child, "");
    EXPECT_EQ(pose.pose.matrix(), expected.matrix());
    const auto covariance = decode_pose(MessageType::pose_with_covariance,
                                        bytes(test::pose_with_covariance_message(transform, big)));
    EXPECT_EQ(covariance.header.stamp, transform.stamp);
    EXPECT_EQ(covariance.pose.matrix(), expected.matrix());
  }
}

TEST(PoseMessages, of_no_rotation_name_the_frames) {
  expect_error(ErrorKind::input,
               "from a to b: the quaternion of the pose is zero: it must have a length", [] {
                 decode_transforms(bytes(test::transforms_message(
                     {{.parent = "a", .child = "b", .rotation = {0, 0, 0, 0}}})));
               });
}

TEST(PoseMessages, cut_anywhere_are_errors) {
  const std::string message =
      test::transforms_message({{.parent = "a", .child = "b"}, {.parent = "b", .child = "c"}});
  for (std::size_t size = 0; size < message.size(); ++size) {
    EXPECT_THROW(decode_transforms(bytes(message.substr(0, size))), Error) << size;
  }
}

}  // namespace
}  // namespace rmap
