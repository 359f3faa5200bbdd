#include "simulation/trajectory.hpp"

#include "simulation/exact_math.hpp"

#include <algorithm>

namespace rmap::simulation {

namespace {

constexpr double kGoldenTurn = 0.38196601125010515;

Pose level_pose(const Vector3d& position, const Vector3d& heading) {
  const Vector3d forward = unit({heading.x(), heading.y(), 0});
  return pose_of_axes(position, forward, {-forward.y(), forward.x(), 0}, Vector3d::UnitZ());
}

// The pose at a distance from the start, measured along the polyline.
Pose pose_at(const std::vector<Vector3d>& corners, double distance) {
  for (std::size_t leg = 0; leg + 1 < corners.size(); ++leg) {
    const Vector3d step = corners[leg + 1] - corners[leg];
    const double whole = length(step);
    if (distance <= whole || leg + 2 == corners.size()) {
      return level_pose(corners[leg] + std::min(1.0, distance / whole) * step, step);
    }
    distance -= whole;
  }
  return Pose::Identity();
}

double total_length(const std::vector<Vector3d>& corners) {
  double total = 0;
  for (std::size_t i = 1; i < corners.size(); ++i) total += length(corners[i] - corners[i - 1]);
  return total;
}

// `count` poses at the shares 0, 1 / parts, 2 / parts ... of the polyline and of the time.
std::vector<TimedPose> spread(const std::vector<Vector3d>& corners, int count, int parts,
                              double duration) {
  const double total = total_length(corners);
  std::vector<TimedPose> poses;
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / parts;
    poses.push_back({.time = share * duration, .map_from_body = pose_at(corners, share * total)});
  }
  return poses;
}

}  // namespace

std::vector<TimedPose> along_path(const std::vector<Vector3d>& corners, int count,
                                  double duration) {
  return spread(corners, count, std::max(1, count - 1), duration);
}

std::vector<TimedPose> around_loop(std::vector<Vector3d> corners, int count, double duration) {
  corners.push_back(Vector3d(corners.front()));
  return spread(corners, count, count, duration);
}

std::vector<TimedPose> all_around(double radius, int count) {
  std::vector<TimedPose> poses;
  for (int i = 0; i < count; ++i) {
    // Equal steps of height cut a sphere into equal areas.
    const double height = 1 - (2 * i + 1.0) / count;
    const double width = std::sqrt(1 - height * height);
    const auto [sine, cosine] = sine_cosine_of_turns(i * kGoldenTurn);
    const Vector3d away = unit({width * cosine, width * sine, height});
    const Vector3d left = unit(cross(Vector3d::UnitZ(), -away));
    poses.push_back(
        {.time = static_cast<double>(i),
         .map_from_body = pose_of_axes(radius * away, -away, left, cross(-away, left))});
  }
  return poses;
}

}  // namespace rmap::simulation
