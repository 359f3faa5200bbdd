#include "io/bin_file.hpp"

#include "io/atomic_file.hpp"
#include "io/bin_columns.hpp"
#include "io/bytes.hpp"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::size_t kPointSize = 16;
constexpr std::size_t kPointsPerPiece = 16384;  // 256 KiB: stays in the cache

}  // namespace

void check_bin_size(const InputFile& file, std::string_view columns, std::size_t point_size) {
  if (file.size() == 0) {
    throw Error(ErrorKind::input,
                fmt::format("{} is empty: a .bin scan holds at least one point of {} bytes",
                            file.path().string(), point_size));
  }
  if (file.size() % point_size != 0) {
    throw Error(
        ErrorKind::input,
        fmt::format(
            "{} has {} bytes: a .bin scan holds {} bytes a point ({}), and {} are left over",
            file.path().string(), file.size(), point_size, columns, file.size() % point_size));
  }
  if (file.size() / point_size > kMaxPointsPerFile) {
    throw Error(ErrorKind::limit,
                fmt::format("{} holds {} points: {} are allowed in a file", file.path().string(),
                            file.size() / point_size, kMaxPointsPerFile));
  }
}

void read_bin(InputFile& file, const PointReadOptions& options, PointCloud& cloud) {
  if (!options.columns.empty()) return read_bin_columns(file, options, cloud);
  check_bin_size(file, "float32 x, y, z, intensity", kPointSize);
  cloud.stored_as_floats = true;
  std::vector<Vector3f>& points = cloud.points;
  points.resize(static_cast<std::size_t>(file.size() / kPointSize));
  std::vector<std::byte> piece(std::min(points.size(), kPointsPerPiece) * kPointSize);
  for (std::size_t begin = 0; begin < points.size(); begin += kPointsPerPiece) {
    const std::size_t count = std::min(kPointsPerPiece, points.size() - begin);
    file.read(std::span(piece).first(count * kPointSize));
    for (std::size_t i = 0; i < count; ++i) {
      const std::byte* bytes = piece.data() + i * kPointSize;
      points[begin + i] = {load_little<float>(bytes), load_little<float>(bytes + 4),
                           load_little<float>(bytes + 8)};
    }
  }
}

void write_bin(const std::filesystem::path& file, std::span<const Vector3f> points) {
  if (points.empty()) {
    throw Error(ErrorKind::input,
                fmt::format("there are no points to write to {}: a .bin scan holds at least one, "
                            "a .pcd may hold none",
                            file.string()));
  }
  AtomicFile output(file);
  for (const Vector3f& point : points) {
    for (const float coordinate : {point.x(), point.y(), point.z(), 0.0F}) {
      output.write(little_endian(coordinate));
    }
  }
  output.commit();
}

}  // namespace rmap
