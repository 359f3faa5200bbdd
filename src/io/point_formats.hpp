#pragma once

#include "io/input_file.hpp"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rmap/box.hpp>

namespace rmap {

/// A format of files that hold the points of one scan each. A new one is a line in
/// point_formats.cpp: folders, single files and read_points then know it.
struct PointFormat {
  std::string_view ending;
  /// Whether a file that begins with this text is surely of the format; null for formats
  /// that cannot be told by their content.
  bool (*looks_like)(std::string_view head);
  void (*read)(InputFile& file, std::vector<Vector3f>& points);
  void (*write)(const std::filesystem::path& file, std::span<const Vector3f> points);
};

/// The format with that ending, or null.
const PointFormat* find_point_format(std::string_view ending);

/// The endings of all formats for messages: ".bin and .pcd".
std::string point_endings();

/// Reads a file of a known ending into `points`. Throws as read_points.
void read_points_into(const std::filesystem::path& file, std::vector<Vector3f>& points);

}  // namespace rmap
