#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include <rmap/pose.hpp>
#include <rmap/scan_read_options.hpp>

namespace rmap {

struct TimedPose {
  std::int64_t stamp = 0;  ///< nanoseconds
  Pose pose = Pose::Identity();
};

/// Where something was in the course of time.
class Trajectory {
 public:
  Trajectory() = default;
  /// In any order; of several poses with one stamp the last one counts.
  explicit Trajectory(std::vector<TimedPose> poses);

  /// Sorted by stamp, each stamp once.
  const std::vector<TimedPose>& poses() const { return poses_; }
  bool empty() const { return poses_.empty(); }

  /// The pose at a time: at a stamp that very pose, in between interpolated by `between`,
  /// nothing before the first and after the last stamp.
  std::optional<Pose> at(std::int64_t stamp) const;

 private:
  std::vector<TimedPose> poses_;
};

/// Reads poses with times from a text file, one a line: 8 numbers (TUM: time in seconds, tx ty
/// tz qx qy qz qw, or qw first by `order`), or 12 (KITTI: 3x4 matrix, row by row) whose times, in
/// seconds, stand one a line in `times`. `#` starts a comment, blank lines are skipped. Throws
/// Error(input) with the line, and Error(usage) when `times` is missing for KITTI lines or given
/// for others.
Trajectory read_trajectory(const std::filesystem::path& file,
                           const std::filesystem::path& times = {},
                           QuaternionOrder order = QuaternionOrder::xyzw);

/// Reads times in seconds, one a line, as nanoseconds; comments as there.
std::vector<std::int64_t> read_times(const std::filesystem::path& file);

}  // namespace rmap
