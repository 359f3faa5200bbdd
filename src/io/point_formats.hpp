#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rmap/box.hpp>

namespace rmap {

/// Which files of a folder are its scans, when it says nothing of them.
enum class InFolder {
  scan,   ///< always
  text,   ///< when there are none of those: text may as well be something else
  never,  ///< names that belong to poses, times and notes
};

/// A format of files that hold the points of one scan each. A new one is a line in
/// point_formats.cpp: folders, single files and read_points then know it.
struct PointFormat {
  std::string_view ending;
  InFolder in_folder;
  /// Whether a file that begins with this text is surely of the format; null for formats
  /// that cannot be told by their content.
  bool (*looks_like)(std::string_view head);
  /// Reads into a cloud that is empty.
  void (*read)(InputFile& file, const PointReadOptions& options, PointCloud& cloud);
  /// Null for formats that are only read.
  void (*write)(const std::filesystem::path& file, std::span<const Vector3f> points);
};

/// The format with that ending, or null.
const PointFormat* find_point_format(std::string_view ending);

/// The endings of all formats for messages: ".bin, .pcd and .ply"; and of those that folders
/// may hold.
std::string point_endings();
std::string folder_endings();

/// Reads a file of a known ending into `cloud`. The offset is off the points, and how many
/// metres lie between neighbouring coordinates there is the result: the quantum of the largest
/// one, as the file or as float32 stores it, or 0 when no coordinate is beyond 1e5.
/// Throws as read_points.
double read_cloud(const std::filesystem::path& file, const PointReadOptions& options,
                  PointCloud& cloud);

}  // namespace rmap
