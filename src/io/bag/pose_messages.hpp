#pragma once

#include "io/bag/cdr.hpp"
#include "io/bag/message_type.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <rmap/pose.hpp>

namespace rmap {

/// std_msgs/Header.
struct MessageHeader {
  std::int64_t stamp = 0;  ///< nanoseconds
  std::string frame = {};  ///< without the slash that ROS 1 put before it
};

/// A pose and what it is of: it carries points of `child` into the frame of the header.
struct StampedPose {
  MessageHeader header = {};
  std::string child = {};  ///< empty where the message does not say
  Pose pose = Pose::Identity();
};

// All of them throw Error(input) as CdrReader, and as make_pose for a pose that is none.

MessageHeader read_header(CdrReader& message);

/// tf2_msgs/TFMessage.
std::vector<StampedPose> decode_transforms(std::span<const std::byte> message);

/// A message of a type that is_pose.
StampedPose decode_pose(MessageType type, std::span<const std::byte> message);

}  // namespace rmap
