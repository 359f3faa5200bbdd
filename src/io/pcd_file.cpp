#include "io/pcd_file.hpp"

#include "io/atomic_file.hpp"
#include "io/byte_reader.hpp"
#include "io/bytes.hpp"
#include "io/lzf.hpp"
#include "io/pcd_header.hpp"
#include "io/text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::size_t kMaxPadding = 65536;  // the largest page in use

// Where the values of one field lie: the first, and the bytes from one to the next.
struct Column {
  const std::byte* first;
  std::size_t step;
};

template <class T>
void copy_column(const Column& column, int axis, std::vector<Vector3f>& points) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i][axis] = static_cast<float>(load_little<T>(column.first + i * column.step));
  }
}

void copy_column(const PcdField& field, const Column& column, int axis,
                 std::vector<Vector3f>& points) {
  if (field.type == 'F') {
    if (field.size == 4) return copy_column<float>(column, axis, points);
    return copy_column<double>(column, axis, points);
  }
  const bool is_signed = field.type == 'I';
  switch (field.size) {
    case 1:
      return is_signed ? copy_column<std::int8_t>(column, axis, points)
                       : copy_column<std::uint8_t>(column, axis, points);
    case 2:
      return is_signed ? copy_column<std::int16_t>(column, axis, points)
                       : copy_column<std::uint16_t>(column, axis, points);
    case 4:
      return is_signed ? copy_column<std::int32_t>(column, axis, points)
                       : copy_column<std::uint32_t>(column, axis, points);
    default:
      return is_signed ? copy_column<std::int64_t>(column, axis, points)
                       : copy_column<std::uint64_t>(column, axis, points);
  }
}

// Early versions of PCL let the file reach a page beyond the data.
bool is_padding(std::span<const std::byte> bytes) {
  return bytes.size() <= kMaxPadding && std::all_of(bytes.begin(), bytes.end(), [](std::byte byte) {
           return byte == std::byte{0};
         });
}

class PcdReader {
 public:
  PcdReader(const std::filesystem::path& file, std::span<const std::byte> bytes,
            std::vector<Vector3f>& points)
      : file_(file),
        header_(parse_pcd_header(file, as_text(bytes))),
        data_(bytes.subspan(header_.size)),
        points_(points) {}

  void read() {
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
    resize_points();
    LineReader lines(as_text(data_));
    std::size_t read = 0;
    while (lines.next()) {
      std::string_view line = lines.line();
      std::string_view rest = line;
      if (next_word(rest).empty()) continue;
      if (read == points_.size()) {
        fail(header_.lines + lines.number(),
             fmt::format("the data go on behind the {} points that are announced", header_.points));
      }
      points_[read++] = parse_point(line, header_.lines + lines.number());
    }
    if (read < points_.size()) {
      throw Error(ErrorKind::input,
                  fmt::format("{} is cut off: it announces {} points and holds {}", file_.string(),
                              header_.points, read));
    }
  }

  Vector3f parse_point(std::string_view line, std::size_t number) const {
    Vector3f point = Vector3f::Zero();
    std::size_t words = 0;
    for (auto word = next_word(line); !word.empty(); word = next_word(line), ++words) {
      for (int axis = 0; axis < 3; ++axis) {
        if (header_.coordinates[static_cast<std::size_t>(axis)].word != words) continue;
        const auto value = parse_float(word);
        if (!value) {
          fail(number,
               fmt::format("{} is {}, which must be a number", "xyz"[axis], in_quotes(word)));
        }
        point[axis] = *value;
      }
    }
    if (words != header_.words) {
      fail(number, fmt::format("the point has {} numbers, which must be {} as the header says",
                               words, header_.words));
    }
    return point;
  }

  void read_binary() {
    // Divided, not multiplied: the product may not fit.
    if (header_.points > data_.size() / header_.point_size) fail_length(data_.size());
    const auto size = static_cast<std::size_t>(header_.points) * header_.point_size;
    if (!is_padding(data_.subspan(size))) fail_length(data_.size());
    resize_points();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const PcdField& field = header_.coordinates[axis];
      copy_column(field, {.first = data_.data() + field.offset, .step = header_.point_size},
                  static_cast<int>(axis), points_);
    }
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
    resize_points();
    std::vector<std::byte> values(size);
    if (!decompress_lzf(compressed, values)) fail_compressed(reader, compressed_size, size);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const PcdField& field = header_.coordinates[axis];
      copy_column(field,
                  {.first = values.data() + field.offset * points_.size(), .step = field.size},
                  static_cast<int>(axis), points_);
    }
  }

  void resize_points() {
    if (header_.points > kMaxPointsPerFile) {
      throw Error(ErrorKind::limit, fmt::format("{} holds {} points: {} are allowed in a file",
                                                file_.string(), header_.points, kMaxPointsPerFile));
    }
    points_.resize(static_cast<std::size_t>(header_.points));
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
  std::vector<Vector3f>& points_;
};

}  // namespace

void read_pcd(InputFile& file, std::vector<Vector3f>& points) {
  const std::vector<std::byte> bytes = file.read_rest();
  PcdReader(file.path(), bytes, points).read();
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
