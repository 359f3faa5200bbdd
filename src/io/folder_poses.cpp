#include "io/folder_poses.hpp"

#include "io/kitti_calibration.hpp"
#include "io/option_meaning.hpp"
#include "io/pose_file.hpp"
#include "io/pose_math.hpp"
#include "io/scan_folder.hpp"
#include "io/tdtk_file.hpp"
#include "io/trajectory.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

bool is_there(const std::filesystem::path& path) {
  std::error_code missing;
  return std::filesystem::exists(path, missing);
}

std::filesystem::path pose_beside(std::filesystem::path file) {
  return file.replace_extension(".pose");
}

bool has_pose_beside(const std::filesystem::path& file) {
  return ending_of(file) == ".3d" && is_there(pose_beside(file));
}

// One pose a scan, in the order of the scans.
std::vector<std::optional<Pose>> read_in_order(const std::filesystem::path& file,
                                               const std::filesystem::path& folder,
                                               std::size_t scans, QuaternionOrder order) {
  const std::vector<Pose> poses = read_poses(file, order);
  if (poses.size() != scans) {
    throw Error(ErrorKind::input,
                fmt::format("{} holds {} poses and {} holds {} scans: there must be one pose for "
                            "each scan",
                            file.string(), poses.size(), folder.string(), scans));
  }
  return {poses.begin(), poses.end()};
}

// Poses of a trajectory at the times of the scans.
std::vector<std::optional<Pose>> read_by_time(const std::filesystem::path& file,
                                              const std::filesystem::path& folder,
                                              std::size_t scans,
                                              const std::filesystem::path& times_file,
                                              QuaternionOrder order) {
  const Trajectory trajectory = read_trajectory(file, {}, order);
  const std::vector<std::int64_t> times = read_times(times_file);
  if (times.size() != scans) {
    throw Error(ErrorKind::input,
                fmt::format("{} holds {} times and {} holds {} scans: there must be one time for "
                            "each scan",
                            times_file.string(), times.size(), folder.string(), scans));
  }
  std::vector<std::optional<Pose>> poses;
  for (const std::int64_t time : times) poses.push_back(trajectory.at(time));
  return poses;
}

std::vector<std::optional<Pose>> read_trajectory_of(const std::filesystem::path& folder,
                                                    std::size_t scans,
                                                    const ScanReadOptions& options) {
  const std::filesystem::path times = options.times.empty() ? folder / "times.txt" : options.times;
  refuse_option(!options.times.empty() && !has_times(options.trajectory), "times (--times)", folder,
                "the poses of its trajectory have none, and are taken in the order of the scans");
  const bool by_time = has_times(options.trajectory) && (!options.times.empty() || is_there(times));
  return by_time ? read_by_time(options.trajectory, folder, scans, times, options.quaternion)
                 : read_in_order(options.trajectory, folder, scans, options.quaternion);
}

// Where KITTI keeps the poses of sequences/NAME.
std::filesystem::path kitti_poses(const std::filesystem::path& folder) {
  const std::filesystem::path whole = std::filesystem::absolute(folder / ".").lexically_normal();
  const std::filesystem::path sequence = whole.parent_path();
  return sequence.parent_path().parent_path() / "poses" / (sequence.filename().string() + ".txt");
}

// Poses of the camera become those of the lidar.
void carry_to_lidar(const std::filesystem::path& calibration, bool in_kittis_layout,
                    FolderPoses& found) {
  if (!is_there(calibration)) {
    if (in_kittis_layout) {
      found.notes.remarks.push_back(
          fmt::format("the poses are taken as those of the lidar: {} would carry those of KITTI's "
                      "camera to it, and is missing",
                      calibration.string()));
    }
    return;
  }
  const auto camera_from_lidar = read_kitti_calibration(calibration);
  if (!camera_from_lidar) {
    throw Error(ErrorKind::input,
                fmt::format("{} has no line Tr: or Tr_velo_to_cam:, which must carry the poses of "
                            "KITTI's camera to the lidar",
                            calibration.string()));
  }
  for (auto& pose : found.poses) {
    if (pose) pose = composed(*pose, *camera_from_lidar);
  }
  found.notes.remarks.push_back(
      fmt::format("the poses are taken as those of KITTI's camera, since {} stands beside the "
                  "scans: its Tr carries them to the lidar, the map lies in the camera's axes",
                  calibration.string()));
}

std::optional<FolderPoses> found_poses(const std::filesystem::path& folder,
                                       std::span<const std::filesystem::path> files,
                                       const ScanReadOptions& options) {
  FolderPoses found;
  if (!options.trajectory.empty()) {
    found.poses = read_trajectory_of(folder, files.size(), options);
    if (!has_times(options.trajectory)) carry_to_lidar(folder / "calib.txt", false, found);
    return found;
  }
  for (const auto& file : {folder / kPosesName, kitti_poses(folder)}) {
    if (!is_there(file)) continue;
    found.poses = read_in_order(file, folder, files.size(), options.quaternion);
    carry_to_lidar(folder / "calib.txt", file.filename() != kPosesName, found);
    return found;
  }
  if (std::none_of(files.begin(), files.end(), has_pose_beside)) return std::nullopt;
  for (const auto& file : files) found.poses.emplace_back(read_3dtk_pose(pose_beside(file)));
  return found;
}

}  // namespace

std::optional<FolderPoses> find_folder_poses(const std::filesystem::path& folder,
                                             std::span<const std::filesystem::path> files,
                                             const ScanReadOptions& options) {
  auto found = found_poses(folder, files, options);
  if (!found) return std::nullopt;
  for (auto& pose : found->poses) {
    if (pose) pose->translation() -= options.offset;
  }
  return found;
}

std::optional<Pose> find_file_pose(const std::filesystem::path& file,
                                   const ScanReadOptions& options) {
  if (!options.trajectory.empty() || !has_pose_beside(file)) return std::nullopt;
  Pose pose = read_3dtk_pose(pose_beside(file));
  pose.translation() -= options.offset;
  return pose;
}

}  // namespace rmap
