#pragma once

#include "io/point_cloud.hpp"

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace rmap {

/// Takes lines of text apart, keeping its memory from line to line.
class WordSplitter {
 public:
  /// The words between blanks and tabs. They live as long as `line` and until the next call.
  const std::vector<std::string_view>& blanks(std::string_view line);
  /// The words between blanks, tabs and semicolons, and commas where no semicolon separates
  /// already; not more than 65536, which are more than any table has. An empty place between two
  /// separators is an empty word.
  const std::vector<std::string_view>& separators(std::string_view line);

 private:
  std::vector<std::string_view> words_;
};

/// Which words of a line are the coordinates of a point.
struct PointWords {
  std::array<std::size_t, 3> point;                  ///< x, y, z
  std::optional<std::array<std::size_t, 3>> origin;  ///< where its beam began
};

/// Turns words into points of a cloud. Options and cloud outlive it.
class PointTextReader {
 public:
  PointTextReader(const PointWords& places, const PointReadOptions& options, PointCloud& cloud);

  /// Adds the point of a line whose words reach to all places. Throws Error(input) naming
  /// file and line when one of them is no number, Error(limit) for too many points.
  void add(const std::filesystem::path& file, std::size_t line,
           std::span<const std::string_view> words);

 private:
  PointWords places_;
  Vector3d offset_;
  PointCloud& cloud_;
};

}  // namespace rmap
