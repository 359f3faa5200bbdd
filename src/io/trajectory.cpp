#include "io/trajectory.hpp"

#include "io/pose_math.hpp"

#include <algorithm>
#include <utility>

namespace rmap {

namespace {

// Of any two times, in their order.
double nanoseconds_between(std::int64_t from, std::int64_t to) {
  return static_cast<double>(static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from));
}

}  // namespace

Trajectory::Trajectory(std::vector<TimedPose> poses) : poses_(std::move(poses)) {
  std::stable_sort(poses_.begin(), poses_.end(),
                   [](const TimedPose& a, const TimedPose& b) { return a.stamp < b.stamp; });
  std::size_t kept = 0;
  for (std::size_t i = 0; i < poses_.size(); ++i) {
    const bool superseded = i + 1 < poses_.size() && poses_[i + 1].stamp == poses_[i].stamp;
    if (!superseded) poses_[kept++] = poses_[i];
  }
  poses_.resize(kept);
}

std::optional<Pose> Trajectory::at(std::int64_t stamp) const {
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), stamp,
                       [](const TimedPose& pose, std::int64_t time) { return pose.stamp < time; });
  if (after == poses_.end()) return std::nullopt;
  if (after->stamp == stamp) return after->pose;
  if (after == poses_.begin()) return std::nullopt;
  const TimedPose& before = *(after - 1);
  return between(
      before.pose, after->pose,
      nanoseconds_between(before.stamp, stamp) / nanoseconds_between(before.stamp, after->stamp));
}

}  // namespace rmap
