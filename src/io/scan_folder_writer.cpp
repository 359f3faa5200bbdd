#include "io/point_formats.hpp"
#include "io/scan_folder.hpp"
#include "io/system_error.hpp"
#include "io/text.hpp"

#include <cassert>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

ScanFolderWriter::ScanFolderWriter(std::filesystem::path folder, std::string ending)
    : folder_(std::move(folder)), ending_(std::move(ending)) {
  const PointFormat* const format = find_point_format(ending_);
  if (format == nullptr || format->write == nullptr) {
    throw Error(ErrorKind::input,
                fmt::format("the ending of the scans is {}, where .bin and .pcd are allowed",
                            in_quotes(ending_)));
  }
  std::error_code code;
  std::filesystem::create_directories(folder_, code);
  if (code) throw system_error("create", folder_, code.value());
  // Files of a longer run before would become scans of this one.
  if (!list_scan_files(folder_).empty() || std::filesystem::exists(folder_ / kPosesName, code)) {
    throw Error(ErrorKind::input,
                fmt::format("{} holds scans or poses already: it must be a folder without them",
                            folder_.string()));
  }
}

void ScanFolderWriter::add(const Scan& scan) {
  assert(!finished_);
  if (scan.frame != Frame::sensor) {
    throw Error(ErrorKind::usage,
                fmt::format("scan {} is in the map's frame: the scans of {} must be in the "
                            "sensor's frame",
                            poses_.size(), folder_.string()));
  }
  write_points(folder_ / fmt::format("{:06}{}", poses_.size(), ending_), scan.points);
  poses_.push_back(scan.map_from_sensor);
}

void ScanFolderWriter::finish() {
  assert(!finished_);
  write_poses(folder_ / kPosesName, poses_);
  finished_ = true;
}

}  // namespace rmap
