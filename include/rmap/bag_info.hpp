#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace rmap {

/// A topic of a bag.
struct BagTopicInfo {
  std::string name = {};
  std::string type = {};      ///< as in the bag: sensor_msgs/msg/PointCloud2
  std::string encoding = {};  ///< cdr for ROS 2
  std::uint64_t messages = 0;
  /// Of the headers of clouds and poses, in order of appearance.
  std::vector<std::string> frames = {};
  /// Of what the poses of nav_msgs/Odometry are.
  std::vector<std::string> child_frames = {};
  /// Why its poses or transforms cannot be used, as a sentence; empty where they can.
  std::string problem = {};
};

/// A frame of the bag's transforms.
struct BagFrameInfo {
  std::string name = {};
  std::string parent = {};
  bool moves = false;       ///< of /tf, not of /tf_static
  std::uint64_t poses = 0;  ///< times at which it is known in its parent; of one that moves
};

/// What comes of a topic of clouds when it is chosen and nothing else.
struct BagCloudsInfo {
  std::string topic = {};
  std::string poses = {};  ///< where they come from: "transforms from odom", say
  std::uint64_t scans = 0;
  std::uint64_t without_pose = 0;
  /// Why the topic cannot be read so, as a sentence with the option that is missing; else empty.
  std::string problem = {};
};

/// What is in a bag.
struct BagInfo {
  std::string format = {};  ///< mcap or sqlite3
  std::uint64_t files = 0;
  std::vector<std::string> compressions = {};  ///< of chunks and messages, "none" too
  std::uint64_t messages = 0;
  std::int64_t first = 0;  ///< time of the first message recorded, ns; without messages 0
  std::int64_t last = 0;
  std::vector<BagTopicInfo> topics = {};  ///< sorted by name
  std::vector<BagFrameInfo> frames = {};  ///< sorted by name; those that hang in another one
  std::string frames_problem = {};        ///< why the transforms cannot be used, else empty
  std::vector<BagCloudsInfo> clouds = {};
  /// A sentence each: that the bag is cut off, say.
  std::vector<std::string> warnings = {};
};

/// Whether the path is a bag as far as its name says: a file .mcap, .db3 or .bag, or a folder
/// with the metadata.yaml of rosbag2.
bool is_bag(const std::filesystem::path& path);

/// Reads all of a bag but the points of its clouds. Throws Error(input) when it is damaged,
/// Error(limit) when it asks for too much memory, Error(io) when it cannot be read.
BagInfo read_bag_info(const std::filesystem::path& path);

}  // namespace rmap
