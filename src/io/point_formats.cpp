#include "io/point_formats.hpp"

#include "io/bin_file.hpp"
#include "io/las_file.hpp"
#include "io/memory.hpp"
#include "io/option_meaning.hpp"
#include "io/pcd_file.hpp"
#include "io/pcd_header.hpp"
#include "io/ply_file.hpp"
#include "io/ply_header.hpp"
#include "io/tdtk_file.hpp"
#include "io/text.hpp"
#include "io/text_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::array kFormats = {
    PointFormat{".bin", InFolder::scan, nullptr, read_bin, write_bin},
    PointFormat{".pcd", InFolder::scan, looks_like_pcd, read_pcd, write_pcd},
    PointFormat{".ply", InFolder::scan, looks_like_ply, read_ply, nullptr},
    PointFormat{".las", InFolder::scan, looks_like_las, read_las, nullptr},
    PointFormat{".laz", InFolder::scan, nullptr, read_las, nullptr},
    PointFormat{".3d", InFolder::scan, nullptr, read_3dtk, nullptr},
    PointFormat{".xyz", InFolder::text, nullptr, read_text_points, nullptr},
    PointFormat{".csv", InFolder::text, nullptr, read_text_points, nullptr},
    PointFormat{".txt", InFolder::never, nullptr, read_text_points, nullptr},
    PointFormat{".dat", InFolder::never, nullptr, read_text_points, nullptr},
};

// The endings of those formats, as a list for people.
template <class Wanted>
std::string list_of(std::span<const PointFormat> formats, Wanted&& wanted) {
  std::vector<std::string_view> endings;
  for (const PointFormat& format : formats) {
    if (wanted(format)) endings.push_back(format.ending);
  }
  const std::string_view last = endings.back();
  endings.pop_back();
  return fmt::format("{} and {}", fmt::join(endings, ", "), last);
}

constexpr std::size_t kHeadSize = 512;
constexpr float kFarCoordinate = 1e5F;

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
    if (other.read == format.read || other.looks_like == nullptr) continue;
    if (other.looks_like(as_text(head))) {
      throw Error(ErrorKind::input, fmt::format("{} is named as a {} file and holds a {} file",
                                                file.path().string(), format.ending, other.ending));
    }
  }
}

// What the reader has left as it is in the file.
void shift(const PointReadOptions& options, PointCloud& cloud) {
  const bool in_map = options.in_map || !cloud.origins.empty();
  if (cloud.shifted || !in_map || options.offset.isZero(0)) return;
  for (Vector3f& point : cloud.points) {
    point = (point.cast<double>() - options.offset).cast<float>();
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

double coordinate_step(std::span<const Vector3f> points) {
  float largest = 0;
  for (const Vector3f& point : points) {
    for (const float coordinate : point) {
      if (std::isfinite(coordinate)) largest = std::max(largest, std::abs(coordinate));
    }
  }
  if (largest <= kFarCoordinate) return 0;
  return static_cast<double>(std::nextafter(largest, std::numeric_limits<float>::infinity())) -
         static_cast<double>(largest);
}

bool is_point_file(const std::filesystem::path& file) {
  return find_point_format(ending_of(file)) != nullptr;
}

std::string point_endings() {
  return list_of(kFormats, [](const PointFormat&) { return true; });
}

std::string folder_endings() {
  return list_of(kFormats,
                 [](const PointFormat& format) { return format.in_folder != InFolder::never; });
}

double read_cloud(const std::filesystem::path& file, const PointReadOptions& options,
                  PointCloud& cloud) {
  const PointFormat& format = format_of(file);
  InputFile input(file);
  check_not_misnamed(input, format);
  cloud.clear();
  with_memory_for(file, [&] { format.read(input, options, cloud); });
  double quantum = cloud.stored_as_floats ? coordinate_step(cloud.points) : 0;
  shift(options, cloud);
  return std::max(quantum, coordinate_step(cloud.points));
}

std::vector<Vector3f> read_points(const std::filesystem::path& file,
                                  const ScanReadOptions& options) {
  constexpr std::string_view kWhy = "its points are taken alone, without beams";
  refuse_bag_options(file, options.bag);
  refuse_place_of_lone_file(file, options, kWhy);
  refuse_trajectory(file, options, kWhy);
  refuse_option(options.no_return.has_value(), "no_return (--no-return)", file, kWhy);
  refuse_columns(file, file, options);
  PointCloud cloud;
  const bool in_map = options.frame.value_or(Frame::map) == Frame::map;
  read_cloud(file, {.in_map = in_map, .offset = options.offset, .columns = options.columns}, cloud);
  return std::move(cloud.points);
}

void write_points(const std::filesystem::path& file, std::span<const Vector3f> points) {
  const PointFormat& format = format_of(file);
  if (format.write == nullptr) {
    throw Error(ErrorKind::input,
                fmt::format("{} cannot be written: points are written as .bin and .pcd, and {} is "
                            "only read",
                            file.string(), format.ending));
  }
  format.write(file, points);
}

}  // namespace rmap
