#include "io/scan_folder.hpp"

#include "io/folder_poses.hpp"
#include "io/natural_order.hpp"
#include "io/option_meaning.hpp"
#include "io/point_formats.hpp"
#include "io/scan_file.hpp"
#include "io/scan_file_source.hpp"
#include "io/system_error.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

// Whether a file of that name is a scan as the others of its folder are.
bool is_scan_name(const std::filesystem::path& path, InFolder kind) {
  const PointFormat* const format = find_point_format(ending_of(path));
  return !path.filename().native().starts_with('.') && format != nullptr &&
         format->in_folder == kind;
}

void check_one_format(const std::filesystem::path& folder,
                      const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) {
    if (ending_of(file) == ending_of(files.front())) continue;
    throw Error(
        ErrorKind::input,
        fmt::format("{} holds scans in two formats, {} and {} for example: one is allowed "
                    "in a folder",
                    folder.string(), files.front().filename().string(), file.filename().string()));
  }
}

Error without_poses(const std::filesystem::path& folder, std::size_t scans) {
  return {
      ErrorKind::input,
      fmt::format("{} is missing: it must hold one pose for each of the {} scans of {}. Or name "
                  "a file of poses (--trajectory), or build from end points (--end-points)",
                  (folder / kPosesName).string(), scans, folder.string())};
}

// Scans without poses of their own in the folder: what the files say themselves.
std::vector<ScanFile> self_posed_files(const std::filesystem::path& folder,
                                       std::vector<std::filesystem::path> paths,
                                       const ScanReadOptions& options) {
  std::vector<ScanFile> files;
  bool any = false;
  for (std::filesystem::path& path : paths) {
    ScanFile file = describe_scan_file(path, options);
    any = any || file.map_from_sensor;
    // One of several viewpoints may be the identity and mean it.
    if (!file.map_from_sensor) {
      file.map_from_sensor = Pose(Eigen::Translation3d(-options.offset));
    }
    file.path = std::move(path);
    files.push_back(std::move(file));
  }
  if (!any) throw without_poses(folder, files.size());
  return files;
}

std::vector<ScanFile> end_point_files(const std::filesystem::path& folder,
                                      std::vector<std::filesystem::path> paths,
                                      const ScanReadOptions& options) {
  if (!options.frame && find_folder_poses(folder, paths, options)) {
    throw Error(ErrorKind::usage,
                fmt::format("{} has poses, so its points are in the sensor's frame: end points "
                            "(--end-points) are points in the map's; if these are, say so (--frame "
                            "world)",
                            folder.string()));
  }
  std::vector<ScanFile> files;
  for (std::filesystem::path& path : paths) {
    files.push_back({.path = std::move(path),
                     .map_from_sensor = Pose::Identity(),
                     .frame = Frame::map,
                     .end_points = true});
  }
  return files;
}

// The folder that the scan files are in: of KITTI's layout the one of the lidar.
std::filesystem::path scan_folder_in(const std::filesystem::path& folder) {
  const std::filesystem::path lidar = folder / "velodyne";
  std::error_code missing;
  const bool nested =
      std::filesystem::is_directory(lidar, missing) && list_scan_files(folder).empty();
  return nested ? lidar : folder;
}

}  // namespace

void check_regular(const std::filesystem::path& path) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (std::filesystem::is_regular_file(status)) return;
  if (code) throw system_error("open", path, code.value());
  throw Error(
      ErrorKind::input,
      fmt::format("{} is {}, and must be a regular file as its name says", path.string(),
                  std::filesystem::is_directory(status) ? "a folder" : "a pipe or a device"));
}

std::vector<std::filesystem::path> list_scan_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::vector<std::filesystem::path> texts;
  std::error_code code;
  std::filesystem::directory_iterator entry(folder, code);
  for (; !code && entry != std::filesystem::directory_iterator(); entry.increment(code)) {
    if (is_scan_name(entry->path(), InFolder::scan)) files.push_back(entry->path());
    if (is_scan_name(entry->path(), InFolder::text)) texts.push_back(entry->path());
  }
  if (code) throw system_error("list", folder, code.value());
  if (files.empty()) files = std::move(texts);
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return natural_less(a.filename().native(), b.filename().native());
  });
  check_one_format(folder, files);
  for (const auto& file : files) check_regular(file);
  return files;
}

std::unique_ptr<ScanSource> open_scan_folder(const std::filesystem::path& folder,
                                             const ScanReadOptions& options) {
  refuse_bag_options(folder, options.bag);
  refuse_lone_times(folder, options);
  if (options.sensor_pose || options.sensor_origin) {
    throw Error(ErrorKind::usage,
                fmt::format("{} is a folder of scans: one sensor pose or origin is for a lone file",
                            folder.string()));
  }
  std::vector<std::filesystem::path> paths = list_scan_files(scan_folder_in(folder));
  if (paths.empty()) {
    throw Error(ErrorKind::input, fmt::format("{} holds no scans: files ending in {} are allowed",
                                              folder.string(), folder_endings()));
  }
  refuse_columns(folder, paths.front(), options);
  if (options.end_points) {
    refuse_trajectory(folder, options, "end points (--end-points) need no poses");
    return open_scan_files(end_point_files(folder, std::move(paths), options), options);
  }
  auto found = find_folder_poses(folder, paths, options);
  if (!found) return open_scan_files(self_posed_files(folder, std::move(paths), options), options);
  std::vector<ScanFile> files;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    files.push_back({.path = std::move(paths[i]),
                     .map_from_sensor = found->poses[i],
                     .frame = options.frame.value_or(Frame::sensor)});
  }
  return open_scan_files(std::move(files), options, std::move(found->notes));
}

}  // namespace rmap
