#include "io/bag/message_type.hpp"

#include <array>
#include <string>
#include <utility>

namespace rmap {

namespace {

using Entry = std::pair<std::string_view, MessageType>;

constexpr std::array kTypes = {
    Entry{"sensor_msgs/PointCloud2", MessageType::cloud},
    Entry{"tf2_msgs/TFMessage", MessageType::transforms},
    Entry{"nav_msgs/Odometry", MessageType::odometry},
    Entry{"geometry_msgs/PoseStamped", MessageType::pose},
    Entry{"geometry_msgs/PoseWithCovarianceStamped", MessageType::pose_with_covariance},
};

}  // namespace

MessageType message_type_of(std::string_view name) {
  std::string plain(name);
  if (const auto middle = plain.find("/msg/"); middle != std::string::npos) {
    plain.erase(middle, 4);
  }
  for (const auto& [known, type] : kTypes) {
    if (plain == known) return type;
  }
  return MessageType::other;
}

bool is_pose(MessageType type) {
  return type == MessageType::odometry || type == MessageType::pose ||
         type == MessageType::pose_with_covariance;
}

}  // namespace rmap
