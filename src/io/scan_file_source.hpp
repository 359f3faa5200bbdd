#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <rmap/scan_read_options.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {

/// A file of points, and how it is a scan.
struct ScanFile {
  std::filesystem::path path;
  /// Nothing: no pose is known, the scan is passed over and counted.
  std::optional<Pose> map_from_sensor;
  Frame frame = Frame::sensor;  ///< of its points, unless they have an origin each
  bool end_points = false;      ///< each point is its own origin
  bool far = false;             ///< its coordinates are known to be beyond what float32 keeps well
};

/// The scans of such files, in their order. The offset of `options` is off the poses already.
std::unique_ptr<ScanSource> open_scan_files(std::vector<ScanFile> files,
                                            const ScanReadOptions& options, ScanNotes notes = {});

}  // namespace rmap
