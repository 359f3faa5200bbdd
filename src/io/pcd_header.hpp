#pragma once

#include "io/number_type.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

#include <rmap/pose.hpp>

namespace rmap {

/// How the points of a PCD file are stored.
enum class PcdData {
  ascii,              ///< a line of numbers for each point
  binary,             ///< one point behind another
  binary_compressed,  ///< LZF of all values of the first field, of the second, ...
};

/// Where to find a coordinate in each point.
struct PcdField {
  NumberType type = NumberType::f32;
  std::size_t offset = 0;  ///< bytes from the start of a point
  std::size_t word = 0;    ///< numbers before it in a line of text
};

/// What the header of a PCD file says, checked on its own: not yet against the data.
struct PcdHeader {
  std::array<PcdField, 3> coordinates;             ///< x, y, z
  std::optional<std::array<PcdField, 3>> origins;  ///< where the beam of each point began
  Pose viewpoint = Pose::Identity();               ///< what most programs write without meaning it
  std::size_t point_size = 0;                      ///< bytes of a point, all fields
  std::size_t words = 0;                           ///< numbers of a point, all fields
  std::uint64_t points = 0;
  PcdData data = PcdData::ascii;
  std::size_t size = 0;   ///< bytes of the header
  std::size_t lines = 0;  ///< lines of the header
};

/// Whether a file that begins with `text` means to be a PCD file.
bool looks_like_pcd(std::string_view text);

/// Reads the header that `text` begins with. FIELDS, SIZE, TYPE and DATA must be there,
/// and POINTS or WIDTH and HEIGHT; where both are, they must agree. VERSION is not
/// used, VIEWPOINT is tx ty tz qw qx qy qz. Throws Error(input) naming `file` and line.
PcdHeader parse_pcd_header(const std::filesystem::path& file, std::string_view text);

}  // namespace rmap
