#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <rmap/box.hpp>
#include <rmap/pose.hpp>
#include <rmap/scan.hpp>

namespace rmap {

/// Which messages of a bag are scans, which ones poses.
struct BagReadOptions {
  /// Of the clouds (sensor_msgs/PointCloud2). Empty: the only such topic of the bag.
  std::string topic = {};
  /// Of the poses: nav_msgs/Odometry, geometry_msgs/PoseStamped or
  /// PoseWithCovarianceStamped. Empty: the chain of /tf and /tf_static where the bag has
  /// one, else the only topic of poses.
  std::string pose_topic = {};
  /// Frame of the map. Empty: the root of the tree of frames that the clouds hang in.
  std::string map_frame = {};
  /// Scans recorded in [from, to] only, seconds after the first message of the bag.
  std::optional<double> from = {};
  std::optional<double> to = {};
};

/// In which order four numbers of a pose are a quaternion.
enum class QuaternionOrder {
  xyzw,  ///< ROS, TUM, Eigen's coefficients
  wxyz,  ///< Hamilton's, as PCL writes it
};

/// The quaternion that four numbers are in that order; it is not normalised.
inline Eigen::Quaterniond quaternion_of(const double* numbers, QuaternionOrder order) {
  return order == QuaternionOrder::xyzw
             ? Eigen::Quaterniond(numbers[3], numbers[0], numbers[1], numbers[2])
             : Eigen::Quaterniond(numbers[0], numbers[1], numbers[2], numbers[3]);
}

/// How scans are to be understood where their files leave a choice or lack something.
/// What has no meaning for the files at hand is an Error(usage) when they are opened.
struct ScanReadOptions {
  /// The frame of the points, where the files do not say. Nothing: the sensor's for scans
  /// with poses; a lone file in the map's frame needs an origin.
  std::optional<Frame> frame = {};
  /// Sensor's frame to the map's, for a lone file without a pose of its own.
  std::optional<Pose> sensor_pose = {};
  /// Where the beams of a lone file in the map's frame began, metres, in the file's
  /// coordinates.
  std::optional<Vector3d> sensor_origin = {};
  /// Take points as ends without beams: cells are hit, nothing is cleared.
  bool end_points = false;
  /// The map's origin in the coordinates of the files, metres: taken off points in the map's
  /// frame, poses and origins, in double, before anything is rounded to float.
  Vector3d offset = Vector3d::Zero();
  /// Points at this distance from the sensor (metres, to 1e-6 of it) are directions without
  /// return: what some drivers write for a beam that came back to nobody.
  std::optional<double> no_return = {};
  /// The columns of `.bin` files: a name each, with its type behind a colon where it is not
  /// f32 (f64, i8 to i64, u8 to u64). Needs x, y and z. Empty: x, y, z, intensity.
  std::vector<std::string> columns = {};
  /// Of poses in text: of 7 or 8 numbers a line.
  QuaternionOrder quaternion = QuaternionOrder::xyzw;
  /// Poses in a file of their own: TUM lines with times, or KITTI lines, one a scan.
  std::filesystem::path trajectory = {};
  /// Times of KITTI poses, one a line, seconds.
  std::filesystem::path times = {};
  BagReadOptions bag = {};
};

}  // namespace rmap
