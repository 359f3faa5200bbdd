#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rmap/pose.hpp>

namespace rmap::test {

/// Messages of ROS 2 in CDR, written plainly: numbers one after another, each at a multiple of
/// its size.
class CdrWriter {
 public:
  explicit CdrWriter(bool big_endian = false)
      : big_endian_(big_endian),
        bytes_(std::string("\0", 1) + (big_endian ? '\0' : '\1') + std::string(2, '\0')) {}

  template <class T>
  CdrWriter& number(T value) {
    while ((bytes_.size() - 4) % sizeof(T) != 0) bytes_ += '\0';
    std::string raw(reinterpret_cast<const char*>(&value), sizeof(T));
    if (big_endian_) std::reverse(raw.begin(), raw.end());
    bytes_ += raw;
    return *this;
  }
  CdrWriter& text(std::string_view text);
  CdrWriter& raw(std::string_view raw);
  /// std_msgs/Header.
  CdrWriter& header(std::int64_t stamp, std::string_view frame);
  CdrWriter& pose(const Vector3d& translation, const Eigen::Quaterniond& rotation);

  const std::string& bytes() const { return bytes_; }

 private:
  bool big_endian_;
  std::string bytes_;
};

struct TestTransform {
  std::int64_t stamp = 0;
  std::string parent = {};
  std::string child = {};
  Vector3d translation = Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
};

std::string transforms_message(const std::vector<TestTransform>& transforms,
                               bool big_endian = false);
std::string odometry_message(const TestTransform& transform, bool big_endian = false);
/// geometry_msgs/PoseStamped; the child is left out.
std::string pose_message(const TestTransform& transform, bool big_endian = false);
std::string pose_with_covariance_message(const TestTransform& transform, bool big_endian = false);

struct TestField {
  std::string name;
  std::uint32_t offset;
  std::uint8_t type;  ///< 1 (int8) to 8 (float64)
  std::uint32_t count = 1;
};

/// A sensor_msgs/PointCloud2, in which any number may be wrong.
struct TestCloud {
  std::int64_t stamp = 0;
  std::string frame = "lidar";
  std::uint32_t height = 1;
  std::uint32_t width = 0;
  std::vector<TestField> fields = {{"x", 0, 7}, {"y", 4, 7}, {"z", 8, 7}};
  bool big_endian_data = false;
  std::uint32_t point_step = 12;
  std::uint32_t row_step = 0;
  std::string data = {};

  std::string message(bool big_endian = false) const;
};

/// A cloud of float32 points, one row of them.
TestCloud cloud_of(std::span<const Vector3f> points, std::int64_t stamp,
                   std::string_view frame = "lidar");

}  // namespace rmap::test
