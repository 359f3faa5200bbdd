#include "io/option_meaning.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

void refuse_option(bool given, std::string_view what, const std::filesystem::path& path,
                   std::string_view why) {
  if (!given) return;
  throw Error(ErrorKind::usage,
              fmt::format("{} has no meaning for {}: {}", what, path.string(), why));
}

void refuse_bag_options(const std::filesystem::path& path, const BagReadOptions& options) {
  constexpr std::string_view kWhy = "it is for bags";
  refuse_option(!options.topic.empty(), "topic (--topic)", path, kWhy);
  refuse_option(!options.pose_topic.empty(), "pose_topic (--pose-topic)", path, kWhy);
  refuse_option(!options.map_frame.empty(), "map_frame (--map-frame)", path, kWhy);
  refuse_option(options.from.has_value(), "from (--from)", path, kWhy);
  refuse_option(options.to.has_value(), "to (--to)", path, kWhy);
}

void refuse_columns(const std::filesystem::path& path, const std::filesystem::path& file,
                    const ScanReadOptions& options) {
  refuse_option(!options.columns.empty() && ending_of(file) != ".bin", "columns (--columns)", path,
                "it is for .bin files");
}

void refuse_place_of_lone_file(const std::filesystem::path& path, const ScanReadOptions& options,
                               std::string_view why) {
  refuse_option(options.sensor_pose.has_value(), "sensor_pose (--sensor-pose)", path, why);
  refuse_option(options.sensor_origin.has_value(), "sensor_origin (--sensor-origin)", path, why);
  refuse_option(options.end_points, "end_points (--end-points)", path, why);
}

void refuse_trajectory(const std::filesystem::path& path, const ScanReadOptions& options,
                       std::string_view why) {
  refuse_option(!options.trajectory.empty(), "trajectory (--trajectory)", path, why);
  refuse_lone_times(path, options);
}

void refuse_lone_times(const std::filesystem::path& path, const ScanReadOptions& options) {
  refuse_option(options.trajectory.empty() && !options.times.empty(), "times (--times)", path,
                "it belongs to the poses of a trajectory (--trajectory), and none is given");
}

}  // namespace rmap
