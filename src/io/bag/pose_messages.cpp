#include "io/bag/pose_messages.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
// A transform of two empty names: stamp, the names' lengths, seven doubles.
constexpr std::size_t kLeastTransform = 8 + 4 + 4 + 7 * 8;

std::string read_frame(CdrReader& message, std::string_view what) {
  std::string_view name = message.text(what);
  if (name.starts_with('/')) name.remove_prefix(1);
  return std::string(name);
}

// Both geometry_msgs/Transform and geometry_msgs/Pose.
Pose read_pose(CdrReader& message) {
  Vector3d translation;
  for (double& number : translation) number = message.number<double>("the translation");
  Eigen::Vector4d rotation;  // x, y, z, w
  for (double& number : rotation) number = message.number<double>("the quaternion");
  return make_pose(translation, Eigen::Quaterniond(rotation));
}

}  // namespace

MessageHeader read_header(CdrReader& message) {
  MessageHeader header;
  const auto seconds = message.number<std::int32_t>("the stamp");
  const auto nanoseconds = message.number<std::uint32_t>("the stamp");
  header.stamp = seconds * kSecond + nanoseconds;
  header.frame = read_frame(message, "the name of the frame");
  return header;
}

std::vector<StampedPose> decode_transforms(std::span<const std::byte> message) {
  CdrReader reader(message);
  const std::uint32_t count = reader.count(kLeastTransform, "transforms");
  std::vector<StampedPose> transforms(count);
  for (StampedPose& transform : transforms) {
    transform.header = read_header(reader);
    transform.child = read_frame(reader, "the name of the child frame");
    try {
      transform.pose = read_pose(reader);
    } catch (const Error& error) {
      throw Error(error.kind(), fmt::format("from {} to {}: {}", transform.header.frame,
                                            transform.child, error.what()));
    }
  }
  return transforms;
}

StampedPose decode_pose(MessageType type, std::span<const std::byte> message) {
  CdrReader reader(message);
  StampedPose pose;
  pose.header = read_header(reader);
  if (type == MessageType::odometry) {
    pose.child = read_frame(reader, "the name of the child frame");
  }
  // Covariances and speeds come behind the pose.
  pose.pose = read_pose(reader);
  return pose;
}

}  // namespace rmap
