#include "io/ply_file.hpp"

#include "io/byte_reader.hpp"
#include "io/ply_header.hpp"
#include "io/point_columns.hpp"
#include "io/point_text.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::string_view kVertex = "vertex";

class PlyReader {
 public:
  PlyReader(const std::filesystem::path& file, std::span<const std::byte> bytes,
            const PointReadOptions& options, PointCloud& cloud)
      : file_(file),
        header_(parse_ply_header(file, as_text(bytes))),
        data_(bytes.subspan(header_.size)),
        options_(options),
        cloud_(cloud) {}

  void read() {
    find_fields();
    if (header_.form == PlyForm::ascii) return read_ascii();
    read_binary();
  }

 private:
  void find_fields() {
    const auto vertex =
        std::find_if(header_.elements.begin(), header_.elements.end(),
                     [](const PlyElement& element) { return element.name == kVertex; });
    if (vertex == header_.elements.end()) fail("its header has no element vertex");
    if (vertex->has_list()) fail("its element vertex has a list, where single values are allowed");
    std::vector<std::string> names;
    for (const PlyProperty& property : vertex->properties) names.push_back(property.name);
    const auto fields = find_point_fields(names);
    if (!fields) fail(fmt::format("the properties of its vertices must have {}", kPointFieldNames));
    fields_ = *fields;
    if (vertex->count > kMaxPointsPerFile) {
      throw Error(ErrorKind::limit, fmt::format("{} holds {} points: {} are allowed in a file",
                                                file_.string(), vertex->count, kMaxPointsPerFile));
    }
  }

  void read_ascii() {
    LineReader lines(as_text(data_));
    WordSplitter split;
    bool read = false;  // the first element of that name is the one
    for (const PlyElement& element : header_.elements) {
      // One without properties is an empty line each or none: nothing to hold on to.
      if (element.properties.empty()) continue;
      const bool vertices = element.name == kVertex && !read;
      if (vertices && element.count > data_.size()) fail_length(element);
      PointTextReader points({.point = fields_.point, .origin = fields_.origin}, options_, cloud_);
      for (std::uint64_t i = 0; i < element.count;) {
        if (!lines.next()) fail_length(element);
        const auto& words = split.blanks(lines.line());
        if (words.empty()) continue;
        ++i;
        if (!vertices) continue;
        const std::size_t line = header_.lines + lines.number();
        if (words.size() != element.properties.size()) {
          throw Error(ErrorKind::input,
                      fmt::format("{}, line {}: the vertex has {} numbers, which must be {} as the "
                                  "header says",
                                  file_.string(), line, words.size(), element.properties.size()));
        }
        points.add(file_, line, words);
      }
      read = read || vertices;
    }
    while (lines.next()) {
      if (!split.blanks(lines.line()).empty()) {
        fail(fmt::format("its data go on behind the last element, in line {}",
                         header_.lines + lines.number()));
      }
    }
  }

  void read_binary() {
    ByteReader bytes(file_, data_, header_.size);
    bool read = false;
    for (const PlyElement& element : header_.elements) {
      if (element.properties.empty()) continue;
      if (element.has_list()) {
        skip_lists(element, bytes);
        continue;
      }
      const std::size_t size = element.size();
      // Divided, not multiplied: the product may not fit.
      if (element.count > bytes.remaining() / size) fail_length(element);
      const auto rows = bytes.take(element.count * size, "the elements of the file");
      if (element.name == kVertex && !read) {
        read_vertices(element, rows);
        read = true;
      }
    }
    if (bytes.remaining() > 0) {
      fail(fmt::format("{} bytes are left over behind its last element", bytes.remaining()));
    }
  }

  void read_vertices(const PlyElement& element, std::span<const std::byte> rows) {
    std::vector<NumberColumn> columns;
    std::size_t place = 0;
    for (const PlyProperty& property : element.properties) {
      columns.push_back({.first = rows.data() + place,
                         .step = element.size(),
                         .type = property.type,
                         .order = order()});
      place += size_of(property.type);
    }
    const auto chosen = [&](const std::array<std::size_t, 3>& places) {
      return std::array<NumberColumn, 3>{columns[places[0]], columns[places[1]],
                                         columns[places[2]]};
    };
    PointColumns all{.point = chosen(fields_.point), .origin = std::nullopt};
    if (fields_.origin) all.origin = chosen(*fields_.origin);
    read_columns(all, static_cast<std::size_t>(element.count), options_, cloud_);
  }

  // Each list takes at least the bytes of its size, so the data bound the steps.
  void skip_lists(const PlyElement& element, ByteReader& bytes) const {
    for (std::uint64_t i = 0; i < element.count; ++i) {
      for (const PlyProperty& property : element.properties) {
        if (property.list_size) {
          bytes.take(list_length(*property.list_size, bytes) * size_of(property.type), "a list");
        } else {
          bytes.take(size_of(property.type), "a property");
        }
      }
    }
  }

  std::uint64_t list_length(NumberType type, ByteReader& bytes) const {
    const auto raw = bytes.take(size_of(type), "the size of a list");
    std::uint64_t length = 0;
    with_type(type, [&](auto number) {
      using T = decltype(number);
      const T value = load_number<T>(raw.data(), order());
      if (value < T{0}) fail("it has a list of negative size");
      length = static_cast<std::uint64_t>(value);
    });
    // At most 2^61 numbers of 8 bytes: the product fits, and is checked against the file.
    return std::min(length, std::uint64_t{1} << 60);
  }

  std::endian order() const {
    return header_.form == PlyForm::big_endian ? std::endian::big : std::endian::little;
  }

  [[noreturn]] void fail_length(const PlyElement& element) const {
    fail(fmt::format("it announces {} elements {} and its {} bytes of data end before",
                     element.count, in_quotes(element.name), data_.size()));
  }

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(ErrorKind::input,
                fmt::format("{} is no sound PLY file: {}", file_.string(), problem));
  }

  const std::filesystem::path& file_;
  PlyHeader header_;
  std::span<const std::byte> data_;
  const PointReadOptions& options_;
  PointCloud& cloud_;
  PointFields fields_ = {};
};

}  // namespace

void read_ply(InputFile& file, const PointReadOptions& options, PointCloud& cloud) {
  const std::vector<std::byte> bytes = file.read_rest();
  PlyReader(file.path(), bytes, options, cloud).read();
}

}  // namespace rmap
