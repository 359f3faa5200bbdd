#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <rmap/scan_source.hpp>

namespace rmap {

/// The file with the poses of a folder's scans.
inline constexpr const char* kPosesName = "poses.txt";

/// The scan files in `folder`, in natural order: all those with the ending of a
/// PointFormat, but for names that begin with a dot. Throws Error(input) when they are
/// not all of one format or not regular files, Error(io) when the folder cannot be read.
std::vector<std::filesystem::path> list_scan_files(const std::filesystem::path& folder);

/// Opens a folder of scan files with poses.txt beside them.
std::unique_ptr<ScanSource> open_scan_folder(const std::filesystem::path& folder,
                                             const ScanReadOptions& options);

/// Opens one scan file of such a folder.
std::unique_ptr<ScanSource> open_scan_file(const std::filesystem::path& file,
                                           const ScanReadOptions& options);

}  // namespace rmap
