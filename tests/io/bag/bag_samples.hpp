#pragma once

#include "support/bag_messages.hpp"
#include "support/bag_writer.hpp"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <rmap/scan_source.hpp>

namespace rmap::test {

inline constexpr std::int64_t kSecond = 1'000'000'000;
inline constexpr std::int64_t kStart = 1'700'000'000 * kSecond;

inline constexpr const char* kCloudType = "sensor_msgs/msg/PointCloud2";
inline constexpr const char* kTransformType = "tf2_msgs/msg/TFMessage";
inline constexpr const char* kOdometryType = "nav_msgs/msg/Odometry";
inline constexpr const char* kPoseType = "geometry_msgs/msg/PoseStamped";
inline constexpr const char* kCovarianceType = "geometry_msgs/msg/PoseWithCovarianceStamped";

/// `clouds` clouds on /points, a second apart from kStart on, each of the one point (i, 2, 3) in
/// the frame lidar; odom -> base moves 1 m a second along x, lidar sits 0.5 m above base.
/// /odom says the same.
TestBag driving_bag(int clouds);

/// What is read of a bag: the x of the first point of each scan, and of its pose.
struct ReadScan {
  float point = 0;
  double place = 0;
  bool operator==(const ReadScan&) const = default;
};
std::vector<ReadScan> scans_of(const std::filesystem::path& bag,
                               const ScanReadOptions& options = {});

void add_transform(TestBag& bag, std::int64_t stamp, std::string parent, std::string child,
                   const Vector3d& translation, const char* topic = "/tf");
void add_cloud(TestBag& bag, std::int64_t stamp, float x, const char* topic = "/points",
               const char* frame = "lidar");

}  // namespace rmap::test
