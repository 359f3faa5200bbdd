#include "io/bag/point_cloud.hpp"

#include "io/point_columns.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

// A field with an empty name: its length, offset, type and count.
constexpr std::size_t kLeastField = 4 + 4 + 1 + 4;

struct Field {
  std::uint32_t offset = 0;
  std::uint8_t type = 0;
  std::uint32_t count = 0;
};

struct Layout {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint32_t point_step = 0;
  std::uint32_t row_step = 0;
  bool big_endian = false;
  std::array<Field, 3> fields = {};
};

// By the number that sensor_msgs/PointField gives a type, from 1.
constexpr std::array kFieldTypes = {NumberType::i8,  NumberType::u8,  NumberType::i16,
                                    NumberType::u16, NumberType::i32, NumberType::u32,
                                    NumberType::f32, NumberType::f64};

NumberType type_of(const Field& field) { return kFieldTypes[field.type - 1U]; }

template <class... Arguments>
Error problem(fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  return {ErrorKind::input, fmt::format(text, std::forward<Arguments>(arguments)...)};
}

void read_fields(CdrReader& message, Layout& layout) {
  constexpr std::string_view kNames = "xyz";
  std::array<bool, 3> found = {};
  std::string names;
  const std::uint32_t count = message.count(kLeastField, "fields");
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::string_view name = message.text("the name of a field");
    const Field field{.offset = message.number<std::uint32_t>("the offset of a field"),
                      .type = message.number<std::uint8_t>("the type of a field"),
                      .count = message.number<std::uint32_t>("the count of a field")};
    if (names.size() < 200) names += (names.empty() ? "" : ", ") + in_quotes(name);
    const auto place = name.size() == 1 ? kNames.find(name[0]) : std::string_view::npos;
    if (place == std::string_view::npos) continue;
    if (found[place]) throw problem("two fields are called {}, where one is allowed", name);
    found[place] = true;
    if (field.type == 0 || field.type > kFieldTypes.size()) {
      throw problem("its field {} is of type {}, where 1 (int8) to 8 (float64) are allowed", name,
                    field.type);
    }
    layout.fields[place] = field;
  }
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (found[i]) continue;
    throw problem("it has no field {}: its fields are {}", kNames[i],
                  names.empty() ? "none" : names);
  }
}

void check_sizes(const Layout& layout, std::size_t data_size) {
  for (std::size_t i = 0; i < layout.fields.size(); ++i) {
    const Field& field = layout.fields[i];
    const std::uint64_t end = std::uint64_t{field.offset} +
                              std::uint64_t{std::max(field.count, 1U)} * size_of(type_of(field));
    if (end > layout.point_step) {
      throw problem("its field {} ends at byte {} of a point, which has {} (point_step)", "xyz"[i],
                    end, layout.point_step);
    }
  }
  const std::uint64_t row = std::uint64_t{layout.width} * layout.point_step;
  if (row > layout.row_step && layout.height > 0) {
    throw problem(
        "its rows of {} points (width) of {} bytes (point_step) take {} bytes, and have "
        "{} (row_step)",
        layout.width, layout.point_step, row, layout.row_step);
  }
  const std::uint64_t all = std::uint64_t{layout.height} * layout.row_step;
  if (all != data_size) {
    throw problem(
        "its {} rows (height) of {} bytes (row_step) take {} bytes, and its data have "
        "{}: width {}, point_step {}",
        layout.height, layout.row_step, all, data_size, layout.width, layout.point_step);
  }
  const std::uint64_t points = std::uint64_t{layout.width} * layout.height;
  if (points > kMaxPointsPerFile) {
    throw Error(ErrorKind::limit,
                fmt::format("it holds {} points (width {}, height {}), and {} "
                            "are allowed",
                            points, layout.width, layout.height, kMaxPointsPerFile));
  }
}

void copy_points(const Layout& layout, std::span<const std::byte> data,
                 std::vector<Vector3f>& points) {
  const std::endian order = layout.big_endian ? std::endian::big : std::endian::little;
  points.resize(std::size_t{layout.width} * layout.height);
  // Rows of nothing may be announced by the billion.
  if (points.empty()) return;
  for (std::size_t row = 0; row < layout.height; ++row) {
    const std::byte* const bytes = data.data() + row * layout.row_step;
    std::array<NumberColumn, 3> columns;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      columns[i] = {.first = bytes + layout.fields[i].offset,
                    .step = layout.point_step,
                    .type = type_of(layout.fields[i]),
                    .order = order};
    }
    read_coordinates(columns, Vector3d::Zero(),
                     std::span(points).subspan(row * layout.width, layout.width));
  }
}

}  // namespace

MessageHeader decode_cloud_header(std::span<const std::byte> message) {
  CdrReader reader(message);
  return read_header(reader);
}

void decode_cloud(std::span<const std::byte> message, std::vector<Vector3f>& points) {
  CdrReader reader(message);
  read_header(reader);
  Layout layout;
  layout.height = reader.number<std::uint32_t>("the height");
  layout.width = reader.number<std::uint32_t>("the width");
  read_fields(reader, layout);
  layout.big_endian = reader.number<std::uint8_t>("is_bigendian") != 0;
  layout.point_step = reader.number<std::uint32_t>("point_step");
  layout.row_step = reader.number<std::uint32_t>("row_step");
  const auto data = reader.bytes("the points");
  check_sizes(layout, data.size());
  copy_points(layout, data, points);
}

}  // namespace rmap
