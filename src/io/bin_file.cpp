#include "io/bin_file.hpp"

#include "io/atomic_file.hpp"
#include "io/bytes.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

constexpr std::size_t kPointSize = 16;
constexpr std::size_t kPointsPerPiece = 16384;  // 256 KiB: stays in the cache

void check_size(const InputFile& file) {
  if (file.size() == 0) {
    throw Error(ErrorKind::input,
                fmt::format("{} is empty: a .bin scan holds at least one point of {} bytes",
                            file.path().string(), kPointSize));
  }
  if (file.size() % kPointSize != 0) {
    throw Error(
        ErrorKind::input,
        fmt::format("{} has {} bytes: a .bin scan holds {} bytes a point (float32 x, y, "
                    "z, intensity), and {} are left over",
                    file.path().string(), file.size(), kPointSize, file.size() % kPointSize));
  }
  if (file.size() / kPointSize > kMaxPointsPerFile) {
    throw Error(ErrorKind::limit,
                fmt::format("{} holds {} points: {} are allowed in a file", file.path().string(),
                            file.size() / kPointSize, kMaxPointsPerFile));
  }
}

}  // namespace

void read_bin(InputFile& file, std::vector<Vector3f>& points) {
  check_size(file);
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
