#include "io/pcd_file.hpp"

#include "io/atomic_file.hpp"
#include "io/byte_reader.hpp"
#include "io/bytes.hpp"
#include "io/lzf.hpp"
#include "io/pcd_header.hpp"
#include "io/point_columns.hpp"
#include "io/point_text.hpp"
#include "io/text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::size_t kMaxPadding = 65536;  // the largest page in use

// Early versions of PCL let the file reach a page beyond the data.
bool is_padding(std::span<const std::byte> bytes) {
  return bytes.size() <= kMaxPadding && std::all_of(bytes.begin(), bytes.end(), [](std::byte byte) {
           return byte == std::byte{0};
         });
}

class PcdReader {
 public:
  PcdReader(const std::filesystem::path& file, std::span<const std::byte> bytes,
            const PointReadOptions& options, PointCloud& cloud)
      : file_(file),
        header_(parse_pcd_header(file, as_text(bytes))),
        data_(bytes.subspan(header_.size)),
        options_(options),
        cloud_(cloud),
        points_(cloud.points) {}

  void read() {
    if (!header_.viewpoint.matrix().isIdentity(0)) cloud_.map_from_sensor = header_.viewpoint;
    switch (header_.data) {
      case PcdData::ascii:
        return read_ascii();
      case PcdData::binary:
        return read_binary();
      case PcdData::binary_compressed:
        return read_compressed();
    }
  }

 private:
  void read_ascii() {
    // A number takes a character and a blank; the last line may have no end.
    if (header_.points > (data_.size() + 1) / (2 * header_.words)) fail_length(data_.size());
    check_count();
    PointWords places{.point = words_of(header_.coordinates), .origin = std::nullopt};
    if (header_.origins) places.origin = words_of(*header_.origins);
    PointTextReader points(places, options_, cloud_);
    points_.reserve(static_cast<std::size_t>(header_.points));
    LineReader lines(as_text(data_));
    while (lines.next()) {
      std::string_view line = lines.line();
      const std::size_t number = header_.lines + lines.number();
      const std::vector<std::string_view>& words = split_.blanks(line);
      if (words.empty()) continue;
      if (points_.size() == header_.points) {
        fail(number,
             fmt::format("the data go on behind the {} points that are announced", header_.points));
      }
      if (words.size() != header_.words) {
        fail(number, fmt::format("the point has {} numbers, which must be {} as the header says",
                                 words.size(), header_.words));
      }
      points.add(file_, number, words);
    }
    if (points_.size() < header_.points) {
      throw Error(ErrorKind::input,
                  fmt::format("{} is cut off: it announces {} points and holds {}", file_.string(),
                              header_.points, points_.size()));
    }
  }

  static std::array<std::size_t, 3> words_of(const std::array<PcdField, 3>& fields) {
    return {fields[0].word, fields[1].word, fields[2].word};
  }

  void read_binary() {
    // Divided, not multiplied: the product may not fit.
    if (header_.points > data_.size() / header_.point_size) fail_length(data_.size());
    const auto size = static_cast<std::size_t>(header_.points) * header_.point_size;
    if (!is_padding(data_.subspan(size))) fail_length(data_.size());
    read_fields([&](const PcdField& field) {
      return NumberColumn{
          .first = data_.data() + field.offset, .step = header_.point_size, .type = field.type};
    });
  }

  void read_compressed() {
    if (header_.points == 0 && data_.empty()) return points_.clear();
    ByteReader reader(file_, data_, header_.size);
    const auto compressed_size = reader.number<std::uint32_t>("the size of the compressed data");
    const auto size = reader.number<std::uint32_t>("the size of the data");
    if (compressed_size > reader.remaining() ||
        !is_padding(data_.last(reader.remaining() - compressed_size))) {
      throw Error(
          ErrorKind::input,
          fmt::format("{} announces {} compressed bytes from byte {} on and holds {}",
                      file_.string(), compressed_size, reader.offset(), reader.remaining()));
    }
    const bool announced =
        size % header_.point_size == 0 && size / header_.point_size == header_.points;
    if (!announced) fail_length(size);
    const auto compressed = reader.take(compressed_size, "the compressed data");
    if (size / kMaxLzfRatio > compressed.size()) fail_compressed(reader, compressed_size, size);
    check_count();
    std::vector<std::byte> values(size);
    if (!decompress_lzf(compressed, values)) fail_compressed(reader, compressed_size, size);
    read_fields([&](const PcdField& field) {
      return NumberColumn{.first = values.data() + field.offset * header_.points,
                          .step = size_of(field.type),
                          .type = field.type};
    });
  }

  // `column` says where the numbers of a field lie.
  template <class Column>
  void read_fields(Column&& column) {
    check_count();
    const auto all = [&](const std::array<PcdField, 3>& fields) {
      return std::array<NumberColumn, 3>{column(fields[0]), column(fields[1]), column(fields[2])};
    };
    PointColumns columns{.point = all(header_.coordinates), .origin = std::nullopt};
    if (header_.origins) columns.origin = all(*header_.origins);
    read_columns(columns, static_cast<std::size_t>(header_.points), options_, cloud_);
  }

  void check_count() const {
    if (header_.points > kMaxPointsPerFile) {
      throw Error(ErrorKind::limit, fmt::format("{} holds {} points: {} are allowed in a file",
                                                file_.string(), header_.points, kMaxPointsPerFile));
    }
  }

  [[noreturn]] void fail_length(std::uint64_t bytes) const {
    if (header_.data == PcdData::ascii) {
      throw Error(ErrorKind::input,
                  fmt::format("{} announces {} points of {} numbers each, for which its {} bytes "
                              "of data have no room",
                              file_.string(), header_.points, header_.words, bytes));
    }
    throw Error(ErrorKind::input,
                fmt::format("{} announces {} points of {} bytes each and holds {} bytes of data",
                            file_.string(), header_.points, header_.point_size, bytes));
  }

  [[noreturn]] void fail_compressed(const ByteReader& reader, std::size_t compressed_size,
                                    std::size_t size) const {
    throw Error(ErrorKind::input,
                fmt::format("{} is damaged: the {} compressed bytes that end at byte {} must give "
                            "{} bytes and do not",
                            file_.string(), compressed_size, reader.offset(), size));
  }

  [[noreturn]] void fail(std::size_t line, const std::string& problem) const {
    throw Error(ErrorKind::input, fmt::format("{}, line {}: {}", file_.string(), line, problem));
  }

  const std::filesystem::path& file_;
  PcdHeader header_;
  std::span<const std::byte> data_;
  const PointReadOptions& options_;
  PointCloud& cloud_;
  std::vector<Vector3f>& points_;  // the cloud's
  WordSplitter split_;
};

}  // namespace

void read_pcd(InputFile& file, const PointReadOptions& options, PointCloud& cloud) {
  const std::vector<std::byte> bytes = file.read_rest();
  PcdReader(file.path(), bytes, options, cloud).read();
}

void write_pcd(const std::filesystem::path& file, std::span<const Vector3f> points) {
  AtomicFile output(file);
  output.write(pcd_header_text({"x", "y", "z"}, points.size()));
  for (const Vector3f& point : points) {
    for (const float coordinate : point) output.write(little_endian(coordinate));
  }
  output.commit();
}

std::string pcd_header_text(std::initializer_list<std::string_view> fields, std::uint64_t points) {
  std::string names;
  std::string sizes;
  std::string types;
  std::string counts;
  for (const std::string_view field : fields) {
    names += fmt::format(" {}", field);
    sizes += " 4";
    types += " F";
    counts += " 1";
  }
  // The blanks behind the comment make up for the digits of the number, which stands twice.
  const std::string number = fmt::format("{}", points);
  const std::size_t padding = 2 * (std::string_view("18446744073709551615").size() - number.size());
  return fmt::format(
      "# .PCD v0.7 - Point Cloud Data file format{:{}}\n"
      "VERSION 0.7\nFIELDS{}\nSIZE{}\nTYPE{}\nCOUNT{}\nWIDTH {}\nHEIGHT 1\n"
      "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n",
      "", padding, names, sizes, types, counts, number, number);
}

}  // namespace rmap
