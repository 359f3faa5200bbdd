#pragma once

#include <string>

#include <CLI/CLI.hpp>

#include <rmap/scan_read_options.hpp>

namespace rmap::command {

/// How scans are read, as options of a verb that reads them.
class ScanOptions {
 public:
  /// Adds the options; their values live as long as this object.
  void add_to(CLI::App& app);

  /// What was asked for. Throws UsageError when a text of it makes no sense.
  ScanReadOptions options() const;

 private:
  void add_bag_options(CLI::App& app);

  ScanReadOptions options_;
  Frame frame_ = Frame::sensor;
  const CLI::Option* frame_option_ = nullptr;
  std::optional<Vector3d> offset_;
  std::string sensor_pose_;
  std::string columns_;
};

}  // namespace rmap::command
