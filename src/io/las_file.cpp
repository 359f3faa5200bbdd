#include "io/las_file.hpp"

#include "io/bytes.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::string_view kMagic = "LASF";
constexpr std::size_t kHeaderSize = 227;    // of versions up to 1.2
constexpr std::size_t kHeaderSize14 = 375;  // with 64-bit numbers of points
constexpr std::byte kPacked{0xC0};          // LAZ sets one of the two highest bits of the format
constexpr std::size_t kPieceSize = 262144;  // stays in the cache

// Bytes that a point of formats 0 to 10 has at least.
constexpr std::array<std::uint16_t, 11> kLeastSizes = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};

struct LasHeader {
  std::uint64_t first_point = 0;  // offset in the file
  std::uint64_t points = 0;
  std::size_t point_size = 0;
  Vector3d scale;
  Vector3d offset;
};

[[noreturn]] void fail(const InputFile& file, const std::string& problem) {
  throw Error(ErrorKind::input,
              fmt::format("{} is no sound LAS file: {}", file.path().string(), problem));
}

void check_version(const InputFile& file, std::span<const std::byte> head) {
  if (!as_text(head).starts_with(kMagic)) {
    fail(file, fmt::format("it does not begin with {}", kMagic));
  }
  if (head.size() < kHeaderSize) {
    fail(file,
         fmt::format("its header has {} bytes, where {} are the least", head.size(), kHeaderSize));
  }
  const int major = std::to_integer<int>(head[24]);
  const int minor = std::to_integer<int>(head[25]);
  if (major != 1 || minor < 2 || minor > 4) {
    fail(file, fmt::format("its version is {}.{}, where 1.2 to 1.4 are allowed", major, minor));
  }
  if (minor == 4 && head.size() < kHeaderSize14) {
    fail(file, fmt::format("its header has {} bytes, where {} are the least", head.size(),
                           kHeaderSize14));
  }
}

Vector3d load_vector(std::span<const std::byte> head, std::size_t offset) {
  return {load_little<double>(head.data() + offset), load_little<double>(head.data() + offset + 8),
          load_little<double>(head.data() + offset + 16)};
}

LasHeader parse_header(const InputFile& file, std::span<const std::byte> head) {
  check_version(file, head);
  if ((head[104] & kPacked) != std::byte{0}) {
    throw Error(ErrorKind::input,
                fmt::format("{} is packed (LAZ): unpack it, with `laszip -i IN.laz -o OUT.las` or "
                            "`pdal translate IN.laz OUT.las`, and read that",
                            file.path().string()));
  }
  const auto format = std::to_integer<std::size_t>(head[104]);
  if (format >= kLeastSizes.size()) {
    fail(file, fmt::format("its points have format {}, where 0 to 10 are allowed", format));
  }
  LasHeader header{.first_point = load_little<std::uint32_t>(head.data() + 96),
                   .points = load_little<std::uint32_t>(head.data() + 107),
                   .point_size = load_little<std::uint16_t>(head.data() + 105),
                   .scale = load_vector(head, 131),
                   .offset = load_vector(head, 155)};
  if (std::to_integer<int>(head[25]) == 4) {
    header.points = load_little<std::uint64_t>(head.data() + 247);
  }
  if (header.point_size < kLeastSizes[format]) {
    fail(file, fmt::format("its points of format {} have {} bytes, where {} are the least", format,
                           header.point_size, kLeastSizes[format]));
  }
  if (!header.scale.allFinite() || !header.offset.allFinite() || header.scale.minCoeff() <= 0) {
    fail(file, "its scale factors must be above zero and its offsets finite");
  }
  const std::uint64_t least = load_little<std::uint16_t>(head.data() + 94);
  if (header.first_point < std::max<std::uint64_t>(least, kHeaderSize) ||
      header.first_point > file.size()) {
    fail(file, fmt::format("its points are said to begin at byte {} of {}, behind a header of {}",
                           header.first_point, file.size(), least));
  }
  if (header.points > (file.size() - header.first_point) / header.point_size) {
    fail(file, fmt::format("it announces {} points of {} bytes each and holds {} bytes of data",
                           header.points, header.point_size, file.size() - header.first_point));
  }
  if (header.points > kMaxPointsPerFile) {
    throw Error(ErrorKind::limit,
                fmt::format("{} holds {} points: {} are allowed in a file", file.path().string(),
                            header.points, kMaxPointsPerFile));
  }
  return header;
}

}  // namespace

bool looks_like_las(std::string_view text) { return text.starts_with(kMagic); }

void read_las(InputFile& file, const PointReadOptions& options, PointCloud& cloud) {
  const LasHeader header = parse_header(file, file.head(kHeaderSize14));
  const Vector3d offset = options.in_map ? options.offset : Vector3d::Zero();
  cloud.shifted = true;
  cloud.points.reserve(static_cast<std::size_t>(header.points));
  file.skip(header.first_point);
  // A point has 65535 bytes at most, so that at least some fit.
  const std::uint64_t points_per_piece = kPieceSize / header.point_size;
  std::vector<std::byte> piece(static_cast<std::size_t>(std::min(points_per_piece, header.points)) *
                               header.point_size);
  while (cloud.points.size() < header.points) {
    const auto count = static_cast<std::size_t>(
        std::min<std::uint64_t>(points_per_piece, header.points - cloud.points.size()));
    file.read(std::span(piece).first(count * header.point_size));
    for (std::size_t i = 0; i < count; ++i) {
      Vector3f point;
      for (int axis = 0; axis < 3; ++axis) {
        const auto value =
            load_little<std::int32_t>(piece.data() + i * header.point_size + 4 * axis);
        point[axis] = static_cast<float>(static_cast<double>(value) * header.scale[axis] +
                                         header.offset[axis] - offset[axis]);
      }
      cloud.points.push_back(point);
    }
  }
}

}  // namespace rmap
