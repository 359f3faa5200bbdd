#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <rmap/scan_read_options.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {

/// The file with the poses of a folder's scans.
inline constexpr const char* kPosesName = "poses.txt";

/// Throws Error when `path` does not exist or is no regular file.
void check_regular(const std::filesystem::path& path);

/// The scan files in `folder`, in natural order: all those with the ending of a
/// PointFormat that is a scan in folders, but for names that begin with a dot. Throws
/// Error(input) when they are not all of one format or not regular files, Error(io) when the
/// folder cannot be read.
std::vector<std::filesystem::path> list_scan_files(const std::filesystem::path& folder);

/// Opens a folder of scan files, or one that holds KITTI's folder velodyne, with poses as
/// find_folder_poses finds them, or in the files themselves.
std::unique_ptr<ScanSource> open_scan_folder(const std::filesystem::path& folder,
                                             const ScanReadOptions& options);

}  // namespace rmap
