#pragma once

#include "io/number_type.hpp"
#include "io/point_cloud.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rmap {

/// Which fields of a point are its coordinates, as places in a list of names.
struct PointFields {
  std::array<std::size_t, 3> point;                  ///< x, y, z
  std::optional<std::array<std::size_t, 3>> origin;  ///< where its beam began
};

/// Finds x, y and z among the names, in any case, and origin_x, origin_y, origin_z, also
/// called ox.., vp_x.. or sensor_x... Nothing unless x, y and z are there once each.
std::optional<PointFields> find_point_fields(std::span<const std::string> names);

/// What find_point_fields needs, for messages.
inline constexpr std::string_view kPointFieldNames = "x, y and z once each";

/// Where the numbers of one field lie: the first, and the bytes from one to the next.
struct NumberColumn {
  const std::byte* first = nullptr;
  std::size_t step = 0;
  NumberType type = NumberType::f32;
  std::endian order = std::endian::little;
};

struct PointColumns {
  std::array<NumberColumn, 3> point;
  std::optional<std::array<NumberColumn, 3>> origin;
};

/// Reads points out of as many places of three binary columns, which the caller has checked to
/// lie in memory: x, y and z less `offset`, as floats.
void read_coordinates(const std::array<NumberColumn, 3>& columns, const Vector3d& offset,
                      std::span<Vector3f> points);

/// Reads `count` points out of binary columns, which the caller has checked to lie in memory.
void read_columns(const PointColumns& columns, std::size_t count, const PointReadOptions& options,
                  PointCloud& cloud);

}  // namespace rmap
