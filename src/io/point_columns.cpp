#include "io/point_columns.hpp"

#include "io/text.hpp"

#include <algorithm>

namespace rmap {

namespace {

using Names = std::array<std::string_view, 3>;

constexpr Names kPointNames = {"x", "y", "z"};
constexpr std::array<Names, 4> kOriginNames = {{{"origin_x", "origin_y", "origin_z"},
                                                {"ox", "oy", "oz"},
                                                {"vp_x", "vp_y", "vp_z"},
                                                {"sensor_x", "sensor_y", "sensor_z"}}};

std::optional<std::array<std::size_t, 3>> find_once(std::span<const std::string> names,
                                                    const Names& wanted) {
  std::array<std::size_t, 3> places = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::size_t found = 0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (!same_letters(names[i], wanted[axis])) continue;
      places[axis] = i;
      ++found;
    }
    if (found != 1) return std::nullopt;
  }
  return places;
}

// Without an offset floats stay bit for bit, whatever they are.
template <class T>
float narrowed(T value, double offset) {
  if (offset == 0) return static_cast<float>(value);
  return static_cast<float>(static_cast<double>(value) - offset);
}

template <class Set>
void for_numbers(const NumberColumn& column, std::size_t count, Set&& set) {
  with_type(column.type, [&](auto type) {
    using T = decltype(type);
    for (std::size_t i = 0; i < count; ++i) {
      set(i, load_number<T>(column.first + i * column.step, column.order));
    }
  });
}

}  // namespace

std::optional<PointFields> find_point_fields(std::span<const std::string> names) {
  const auto point = find_once(names, kPointNames);
  if (!point) return std::nullopt;
  PointFields fields{.point = *point, .origin = std::nullopt};
  for (const Names& origin : kOriginNames) {
    fields.origin = find_once(names, origin);
    if (fields.origin) break;
  }
  return fields;
}

void read_coordinates(const std::array<NumberColumn, 3>& columns, const Vector3d& offset,
                      std::span<Vector3f> points) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int row = static_cast<int>(axis);
    for_numbers(columns[axis], points.size(),
                [&](std::size_t i, auto value) { points[i][row] = narrowed(value, offset[row]); });
  }
}

void read_columns(const PointColumns& columns, std::size_t count, const PointReadOptions& options,
                  PointCloud& cloud) {
  const bool in_map = options.in_map || columns.origin;
  const Vector3d offset = in_map ? options.offset : Vector3d::Zero();
  cloud.points.resize(count);
  cloud.stored_as_floats = true;
  // What is stored as floats is shifted later, when it is known how large it was.
  for (const NumberColumn& column : columns.point) {
    cloud.stored_as_floats = cloud.stored_as_floats && column.type == NumberType::f32;
  }
  cloud.shifted = !cloud.stored_as_floats;
  read_coordinates(columns.point, cloud.shifted ? offset : Vector3d::Zero(), cloud.points);
  if (!columns.origin) return;
  cloud.origins.resize(count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int row = static_cast<int>(axis);
    for_numbers((*columns.origin)[axis], count, [&](std::size_t i, auto value) {
      cloud.origins[i][row] = static_cast<double>(value) - offset[row];
    });
  }
}

}  // namespace rmap
