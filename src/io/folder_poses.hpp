#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include <rmap/scan_read_options.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {

/// Where the scans of a folder were taken.
struct FolderPoses {
  /// Sensor's frame to the map's, one for each scan; nothing where none is known.
  std::vector<std::optional<Pose>> poses;
  ScanNotes notes;
};

/// Looks for the poses of the scan `files` of `folder`, in this order: the trajectory of the
/// options; poses.txt in the folder; in KITTI's layout ../../poses/NAME.txt; for each file a
/// .pose of 3DTK. With KITTI's calib.txt in the folder they are the camera's, and its line Tr
/// carries them to the lidar. The offset is taken off. Nothing when there are none.
std::optional<FolderPoses> find_folder_poses(const std::filesystem::path& folder,
                                             std::span<const std::filesystem::path> files,
                                             const ScanReadOptions& options);

/// The pose that stands beside one scan file of 3DTK, the offset taken off.
std::optional<Pose> find_file_pose(const std::filesystem::path& file,
                                   const ScanReadOptions& options);

}  // namespace rmap
