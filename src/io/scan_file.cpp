#include "io/scan_file.hpp"

#include "io/folder_poses.hpp"
#include "io/option_meaning.hpp"
#include "io/point_formats.hpp"
#include "io/scan_folder.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

Error contradiction(const std::filesystem::path& file, std::string_view what) {
  return {ErrorKind::usage, fmt::format("{}: {}", file.string(), what)};
}

void check_options(const std::filesystem::path& file, const ScanReadOptions& options) {
  if (options.sensor_pose.has_value() + options.sensor_origin.has_value() + options.end_points >
      1) {
    throw contradiction(file,
                        "a sensor pose, a sensor origin and end points exclude one another: each "
                        "says where its beams began");
  }
  refuse_bag_options(file, options.bag);
  refuse_columns(file, file, options);
  if (options.sensor_pose || options.sensor_origin || options.end_points) {
    refuse_trajectory(file, options, "another option says where its beams began");
  }
  refuse_lone_times(file, options);
  if (options.frame != Frame::sensor) return;
  if (options.sensor_origin) {
    throw contradiction(file,
                        "an origin alone does not carry points of the sensor's frame into the map: "
                        "a sensor pose (--sensor-pose) does");
  }
  if (options.end_points) {
    throw contradiction(file, "end points are in the map's frame, not in the sensor's");
  }
}

Pose translation(const Vector3d& place) {
  Pose pose = Pose::Identity();
  pose.translation() = place;
  return pose;
}

// What the options say of where the beams of a lone file began.
std::optional<ScanFile> asked_for(const std::filesystem::path& file,
                                  const ScanReadOptions& options) {
  ScanFile scan{.path = file, .map_from_sensor = Pose::Identity()};
  if (options.end_points) {
    scan.frame = Frame::map;
    scan.end_points = true;
  } else if (options.sensor_origin) {
    scan.frame = Frame::map;
    scan.map_from_sensor = translation(*options.sensor_origin - options.offset);
  } else if (options.sensor_pose) {
    scan.frame = options.frame.value_or(Frame::sensor);
    scan.map_from_sensor = options.sensor_pose;
    scan.map_from_sensor->translation() -= options.offset;
  } else {
    return std::nullopt;
  }
  return scan;
}

// The place of the file among the scans of its folder, which have poses.
std::optional<ScanFile> posed_in_folder(const std::filesystem::path& file,
                                        const ScanReadOptions& options) {
  ScanFile scan{.path = file,
                .map_from_sensor = find_file_pose(file, options),
                .frame = options.frame.value_or(Frame::sensor)};
  if (scan.map_from_sensor) return scan;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code missing;
  if (options.trajectory.empty() && !std::filesystem::exists(folder / kPosesName, missing)) {
    return std::nullopt;
  }
  const std::vector<std::filesystem::path> files = list_scan_files(folder);
  const auto place = std::find_if(files.begin(), files.end(), [&](const auto& other) {
    return other.filename() == file.filename();
  });
  if (place == files.end()) return std::nullopt;
  const auto found = find_folder_poses(folder, files, options);
  if (!found) return std::nullopt;
  scan.map_from_sensor = found->poses[static_cast<std::size_t>(place - files.begin())];
  return scan;
}

}  // namespace

ScanFile describe_scan_file(const std::filesystem::path& file, const ScanReadOptions& options) {
  PointCloud cloud;
  const PointReadOptions reading{
      .in_map = true, .offset = options.offset, .columns = options.columns};
  const bool far = read_cloud(file, reading, cloud) > 0;
  ScanFile scan{.path = file, .map_from_sensor = std::nullopt, .far = far};
  if (!cloud.origins.empty()) {
    scan.frame = Frame::map;
    scan.map_from_sensor = translation(Vector3d::Zero());
  } else if (cloud.map_from_sensor) {
    scan.frame = options.frame.value_or(Frame::sensor);
    scan.map_from_sensor = cloud.map_from_sensor;
    scan.map_from_sensor->translation() -= options.offset;
  }
  return scan;
}

std::unique_ptr<ScanSource> open_scan_file(const std::filesystem::path& file,
                                           const ScanReadOptions& options) {
  check_regular(file);
  check_options(file, options);
  std::optional<ScanFile> scan = asked_for(file, options);
  if (!scan) scan = posed_in_folder(file, options);
  if (!scan) scan = describe_scan_file(file, options);
  if (!scan->map_from_sensor) {
    throw Error(
        ErrorKind::input,
        fmt::format("{} does not say where its beams began: give the place of the sensor "
                    "(--sensor-origin X,Y,Z, for points in the map's frame) or its pose "
                    "(--sensor-pose X,Y,Z,QX,QY,QZ,QW, for points in the sensor's), or take "
                    "its points as ends alone (--end-points){}",
                    file.string(),
                    scan->far ? ". Its coordinates are beyond 1e5, where float32 loses digits: an "
                                "offset near them (--offset X,Y,Z) keeps them"
                              : ""));
  }
  return open_scan_files({std::move(*scan)}, options);
}

}  // namespace rmap
