#include "io/atomic_file.hpp"
#include "io/bytes.hpp"
#include "io/pcd_file.hpp"
#include "io/point_formats.hpp"
#include "io/text.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include <rmap/cell_files.hpp>
#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

// How a form begins, knowing the number of cells, and what it has for each. The header
// must be as long for any number: it is replaced when the number is known.
struct CellForm {
  std::string_view ending;
  std::string (*header)(std::uint64_t cells);
  void (*write)(AtomicFile& file, const CellRow& row);
};

std::string csv_header(std::uint64_t) { return "x,y,z,size,probability,state\n"; }

void write_csv(AtomicFile& file, const CellRow& row) {
  fmt::memory_buffer line;
  fmt::format_to(fmt::appender(line), "{},{},{},{},{},{}\n", row.center.x(), row.center.y(),
                 row.center.z(), row.size, row.probability, row.occupied ? "occupied" : "free");
  file.write(std::string_view(line.data(), line.size()));
}

void write_float(AtomicFile& file, double value) {
  file.write(little_endian(static_cast<float>(value)));
}

std::string ply_header(std::uint64_t cells) {
  // The blanks behind the comment make up for the digits of the number.
  const std::string number = fmt::format("{}", cells);
  const std::size_t padding = std::string_view("18446744073709551615").size() - number.size();
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment centres of the cells of a map{:{}}\n"
      "element vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
      "property float probability\nproperty uchar state\nend_header\n",
      "", padding, number);
}

void write_ply(AtomicFile& file, const CellRow& row) {
  for (const double coordinate : row.center) write_float(file, coordinate);
  write_float(file, row.probability);
  file.write(little_endian(static_cast<std::uint8_t>(row.occupied ? 1 : 0)));
}

std::string pcd_header(std::uint64_t cells) {
  return pcd_header_text({"x", "y", "z", "probability"}, cells);
}

void write_pcd_point(AtomicFile& file, const CellRow& row) {
  for (const double coordinate : row.center) write_float(file, coordinate);
  write_float(file, row.probability);
}

constexpr std::array kForms = {
    CellForm{.ending = ".csv", .header = csv_header, .write = write_csv},
    CellForm{.ending = ".ply", .header = ply_header, .write = write_ply},
    CellForm{.ending = ".pcd", .header = pcd_header, .write = write_pcd_point},
};

const CellForm& form_of(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  for (const CellForm& form : kForms) {
    if (form.ending == ending) return form;
  }
  throw Error(ErrorKind::input,
              fmt::format("the ending of {} is {}, where .csv, .ply and .pcd are allowed",
                          file.string(), in_quotes(ending)));
}

}  // namespace

std::uint64_t write_cells(const std::filesystem::path& file, FunctionRef<void(CellSink)> cells) {
  const CellForm& form = form_of(file);
  AtomicFile output(file);
  const std::string header = form.header(0);
  output.write(header);
  std::uint64_t count = 0;
  cells([&](const CellRow& row) {
    form.write(output, row);
    ++count;
  });
  const std::string final_header = form.header(count);
  if (final_header != header) output.overwrite(0, final_header);
  output.commit();
  return count;
}

}  // namespace rmap
