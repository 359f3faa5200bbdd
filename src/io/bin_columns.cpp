#include "io/bin_columns.hpp"

#include "io/bin_file.hpp"
#include "io/point_columns.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

// A column as it was asked for.
struct BinColumn {
  std::string name;
  NumberType type = NumberType::f32;
};

constexpr std::array<std::pair<std::string_view, NumberType>, 10> kTypes = {
    {{"i8", NumberType::i8},
     {"u8", NumberType::u8},
     {"i16", NumberType::i16},
     {"u16", NumberType::u16},
     {"i32", NumberType::i32},
     {"u32", NumberType::u32},
     {"i64", NumberType::i64},
     {"u64", NumberType::u64},
     {"f32", NumberType::f32},
     {"f64", NumberType::f64}}};

BinColumn parse_column(const std::string& text) {
  const std::size_t colon = text.find(':');
  BinColumn column{.name = text.substr(0, colon)};
  if (colon == std::string::npos) return column;
  const std::string_view type = std::string_view(text).substr(colon + 1);
  const auto known = std::find_if(kTypes.begin(), kTypes.end(),
                                  [&](const auto& entry) { return entry.first == type; });
  if (known == kTypes.end()) {
    throw Error(ErrorKind::usage,
                fmt::format("the column {} of .bin files has the type {}, where i8, u8, i16, u16, "
                            "i32, u32, i64, u64, f32 and f64 are allowed",
                            in_quotes(text), in_quotes(type)));
  }
  column.type = known->second;
  return column;
}

}  // namespace

void read_bin_columns(InputFile& file, const PointReadOptions& options, PointCloud& cloud) {
  std::vector<std::string> names;
  std::vector<NumberColumn> columns;
  std::size_t point_size = 0;
  for (const std::string& text : options.columns) {
    BinColumn column = parse_column(text);
    names.push_back(std::move(column.name));
    columns.push_back({.first = nullptr, .step = point_size, .type = column.type});
    point_size += size_of(column.type);
  }
  const auto fields = find_point_fields(names);
  if (!fields) {
    throw Error(ErrorKind::usage, fmt::format("the columns of .bin files are {}: there must be {}",
                                              fmt::join(options.columns, ","), kPointFieldNames));
  }
  check_bin_size(file, fmt::format("{}", fmt::join(options.columns, ", ")), point_size);
  const std::vector<std::byte> bytes = file.read_rest();
  // So far `step` is where the column begins in a point.
  const auto placed = [&](const std::array<std::size_t, 3>& places) {
    std::array<NumberColumn, 3> found;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      found[axis] = columns[places[axis]];
      found[axis].first = bytes.data() + found[axis].step;
      found[axis].step = point_size;
    }
    return found;
  };
  PointColumns chosen{.point = placed(fields->point), .origin = std::nullopt};
  if (fields->origin) chosen.origin = placed(*fields->origin);
  read_columns(chosen, bytes.size() / point_size, options, cloud);
}

}  // namespace rmap
