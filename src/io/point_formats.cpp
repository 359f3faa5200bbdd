#include "io/point_formats.hpp"

#include "io/bin_file.hpp"
#include "io/memory.hpp"
#include "io/pcd_file.hpp"
#include "io/pcd_header.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::array kFormats = {
    PointFormat{.ending = ".bin", .looks_like = nullptr, .read = read_bin, .write = write_bin},
    PointFormat{
        .ending = ".pcd", .looks_like = looks_like_pcd, .read = read_pcd, .write = write_pcd},
};

constexpr std::size_t kHeadSize = 512;

const PointFormat& format_of(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  if (const PointFormat* format = find_point_format(ending)) return *format;
  throw Error(ErrorKind::input, fmt::format("the ending of {} is {}, where {} are allowed",
                                            file.string(), in_quotes(ending), point_endings()));
}

// Formats without a mark of their own would read another format's bytes as points.
void check_not_misnamed(const InputFile& file, const PointFormat& format) {
  const std::vector<std::byte> head = file.head(kHeadSize);
  for (const PointFormat& other : kFormats) {
    if (&other == &format || other.looks_like == nullptr) continue;
    if (other.looks_like(as_text(head))) {
      throw Error(ErrorKind::input, fmt::format("{} is named as a {} file and holds a {} file",
                                                file.path().string(), format.ending, other.ending));
    }
  }
}

}  // namespace

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& character : ending) {
    if (character >= 'A' && character <= 'Z') character = static_cast<char>(character + 'a' - 'A');
  }
  return ending;
}

const PointFormat* find_point_format(std::string_view ending) {
  const auto found = std::find_if(kFormats.begin(), kFormats.end(), [&](const PointFormat& format) {
    return format.ending == ending;
  });
  return found == kFormats.end() ? nullptr : &*found;
}

std::string point_endings() {
  std::vector<std::string_view> endings;
  endings.reserve(kFormats.size());
  for (const PointFormat& format : kFormats) endings.push_back(format.ending);
  return fmt::format("{}", fmt::join(endings, " and "));
}

void read_points_into(const std::filesystem::path& file, std::vector<Vector3f>& points) {
  const PointFormat& format = format_of(file);
  InputFile input(file);
  check_not_misnamed(input, format);
  with_memory_for(file, [&] { format.read(input, points); });
}

std::vector<Vector3f> read_points(const std::filesystem::path& file) {
  std::vector<Vector3f> points;
  read_points_into(file, points);
  return points;
}

void write_points(const std::filesystem::path& file, std::span<const Vector3f> points) {
  format_of(file).write(file, points);
}

}  // namespace rmap
