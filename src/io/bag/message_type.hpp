#pragma once

#include <string_view>

namespace rmap {

/// What the messages of a topic mean to us.
enum class MessageType {
  cloud,                 ///< sensor_msgs/PointCloud2
  transforms,            ///< tf2_msgs/TFMessage
  odometry,              ///< nav_msgs/Odometry
  pose,                  ///< geometry_msgs/PoseStamped
  pose_with_covariance,  ///< geometry_msgs/PoseWithCovarianceStamped
  other,
};

/// Of a type's name with or without the "msg/" that ROS 2 puts in the middle.
MessageType message_type_of(std::string_view name);

/// Whether messages of the type say where one thing was.
bool is_pose(MessageType type);

}  // namespace rmap
