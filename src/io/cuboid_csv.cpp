#include "io/cuboid_formats.hpp"
#include "io/input_file.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

// The frame as a matrix, which gives the same pose back; a quaternion would be rounded.
constexpr std::string_view kStart = "# rmap cuboids; resolution ";
constexpr std::string_view kFrame = " m; frame, from the input to the cells, 3x4 by rows: ";
constexpr std::array<std::string_view, 8> kColumns = {"min_x", "min_y", "min_z",  "max_x",
                                                      "max_y", "max_z", "points", "density"};
constexpr std::size_t kPoints = 6;
constexpr std::size_t kDensity = 7;
constexpr double kOnLattice = 1e-6;  // in cells
constexpr double kSameDensity = 1e-9;

std::string header() { return fmt::format("{}", fmt::join(kColumns, ",")); }

// The text before the first `separator`, which both are taken off.
std::string_view next_part(std::string_view& text, std::string_view separator) {
  const std::size_t end = text.find(separator);
  const std::string_view part = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
  return part;
}

class CsvReader {
 public:
  explicit CsvReader(const std::filesystem::path& file)
      : file_(file), bytes_(InputFile(file).read_rest()), lines_(as_text(bytes_)) {}

  CuboidList read() {
    CuboidList list;
    read_comment(list);
    const Lattice lattice(list.resolution);
    if (!lines_.next() || lines_.line() != header()) {
      throw error(2, fmt::format("the header must be {}", header()));
    }
    while (lines_.next()) list.cuboids.push_back(read_cuboid(lattice));
    return list;
  }

 private:
  void read_comment(CuboidList& list) {
    lines_.next();
    std::string_view line = lines_.line();
    if (!line.starts_with(kStart)) {
      throw error(1, fmt::format("a file of cuboids must begin with {}", in_quotes(kStart)));
    }
    line.remove_prefix(kStart.size());
    list.resolution = number("the resolution", next_part(line, kFrame));
    for (int row = 0; row < 3; ++row) {
      for (int column = 0; column < 4; ++column) {
        list.frame(row, column) = number("the frame", next_part(line, " "));
      }
    }
    try {
      Lattice{list.resolution};
      check_pose(list.frame);
    } catch (const Error& wrong) {
      throw error(wrong.what());
    }
    if (!line.empty()) throw error(fmt::format("{} follows the frame", in_quotes(line)));
  }

  Cuboid read_cuboid(const Lattice& lattice) const {
    const auto fields = split();
    Cuboid cuboid;
    for (int axis = 0; axis < 3; ++axis) {
      const auto low = static_cast<std::size_t>(axis);
      cuboid.cells.min[axis] = border(lattice, axis, kColumns[low], fields[low]);
      cuboid.cells.max[axis] = border(lattice, axis, kColumns[low + 3], fields[low + 3]);
      if (cuboid.cells.min[axis] < cuboid.cells.max[axis]) continue;
      throw error(fmt::format("{} is {}, which must be less than {}, {}", kColumns[low],
                              fields[low], kColumns[low + 3], fields[low + 3]));
    }
    const auto points = parse_unsigned(fields[kPoints]);
    if (!points) throw error(fmt::format("points is {}, no count", in_quotes(fields[kPoints])));
    cuboid.points = *points;
    // It says nothing new, but it is the end of the line, where a file may be cut off.
    const auto density = parse_double(fields[kDensity]);
    if (!density || !(std::abs(*density - cuboid.density()) <= kSameDensity * cuboid.density())) {
      throw error(fmt::format("density is {}, where points by volume in cells is {}",
                              in_quotes(fields[kDensity]), cuboid.density()));
    }
    return cuboid;
  }

  std::array<std::string_view, kColumns.size()> split() const {
    std::array<std::string_view, kColumns.size()> fields;
    std::string_view rest = lines_.line();
    const auto commas = static_cast<std::size_t>(std::count(rest.begin(), rest.end(), ','));
    if (commas + 1 != fields.size()) {
      throw error(
          fmt::format("the line has {} fields, which must be {}", commas + 1, fields.size()));
    }
    for (std::string_view& field : fields) field = next_part(rest, ",");
    return fields;
  }

  // The index of the cell border that a field names in metres.
  std::int32_t border(const Lattice& lattice, int axis, std::string_view name,
                      std::string_view field) const {
    const double metres = number(name, field);
    const double cells = lattice.to_cells(Vector3d::Constant(metres))[axis];
    const double nearest = std::round(cells);
    if (!(std::abs(cells - nearest) <= kOnLattice)) {
      throw error(fmt::format("{} is {} m, which is no border of cells of {} m", name, field,
                              lattice.resolution()));
    }
    if (!(nearest >= kMinCellIndex && nearest <= kMaxCellIndex + 1.0)) {
      throw error(
          fmt::format("{} is {} m, which is beyond the limits of cell indices", name, field));
    }
    return static_cast<std::int32_t>(nearest);
  }

  double number(std::string_view name, std::string_view field) const {
    const auto value = parse_double(field);
    if (value && std::isfinite(*value)) return *value;
    throw error(fmt::format("{} is {}, no finite number", name, in_quotes(field)));
  }

  Error error(std::string_view problem) const { return error(lines_.number(), problem); }
  Error error(std::size_t line, std::string_view problem) const {
    return {ErrorKind::input, fmt::format("{}, line {}: {}", file_.string(), line, problem)};
  }

  std::filesystem::path file_;
  std::vector<std::byte> bytes_;
  LineReader lines_;
};

}  // namespace

void write_cuboid_csv(AtomicFile& file, const CuboidList& list) {
  std::string comment = fmt::format("{}{}{}", kStart, list.resolution, kFrame);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      comment += fmt::format("{}{}", row + column == 0 ? "" : " ", list.frame(row, column));
    }
  }
  file.write(comment + '\n');
  file.write(header() + '\n');
  const Lattice lattice(list.resolution);
  for (const Cuboid& cuboid : list.cuboids) {
    const Box box = lattice.metric(cuboid.cells);
    fmt::memory_buffer line;
    fmt::format_to(fmt::appender(line), "{},{},{},{},{},{},{},{}\n", box.min.x(), box.min.y(),
                   box.min.z(), box.max.x(), box.max.y(), box.max.z(), cuboid.points,
                   cuboid.density());
    file.write(std::string_view(line.data(), line.size()));
  }
}

CuboidList read_cuboid_csv(const std::filesystem::path& file) { return CsvReader(file).read(); }

}  // namespace rmap
