#include "io/byte_reader.hpp"
#include "io/cuboid_formats.hpp"
#include "io/input_file.hpp"
#include "io/rmap_checksum.hpp"
#include "io/rmap_compression.hpp"
#include "io/rmap_format.hpp"
#include "io/rmap_records.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

// docs/formats/rcs.md says what lies in the file.
namespace rmap {

namespace {

constexpr std::uint32_t kVersion = 1;
constexpr std::array<unsigned char, 8> kMagic = {0x89, 'R', 'C', 'S', '\r', '\n', 0x1A, '\n'};
constexpr std::uint32_t kCompressed = 1;
constexpr std::size_t kFrameSize = kMagic.size() + 2 * sizeof(std::uint32_t) + sizeof(double) +
                                   wire::kPoseSize + sizeof(std::uint64_t);
constexpr std::size_t kRawSize = 6 * sizeof(std::uint32_t) + sizeof(std::uint64_t);
// What a cuboid takes in the file at least, however well it compresses: bounds the memory for a
// list by the length of its file.
constexpr std::size_t kLeastSize = 1;

// Small numbers of both signs become small numbers: 0, -1, 1, -2, ...
std::uint32_t zigzag(std::uint32_t step) { return (step << 1) ^ (0U - (step >> 31)); }
std::uint32_t unzigzag(std::uint32_t code) { return (code >> 1) ^ (0U - (code & 1U)); }

// The lowest bytes of all numbers, then all the second ones, and so on: the high ones are mostly
// zeros, which take next to nothing.
template <class T, class NumberOf>
void append_planes(std::vector<std::byte>& content, std::size_t count, NumberOf&& number_of) {
  const std::size_t start = content.size();
  content.resize(start + sizeof(T) * count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bytes = little_endian<T>(number_of(i));
    for (std::size_t plane = 0; plane < sizeof(T); ++plane) {
      content[start + plane * count + i] = bytes[plane];
    }
  }
}

template <class T>
T from_planes(std::span<const std::byte> column, std::size_t i) {
  const std::size_t count = column.size() / sizeof(T);
  std::array<std::byte, sizeof(T)> bytes;
  for (std::size_t plane = 0; plane < sizeof(T); ++plane) bytes[plane] = column[plane * count + i];
  return load_little<T>(bytes.data());
}

std::vector<std::byte> encoded(const std::vector<Cuboid>& cuboids) {
  std::vector<std::byte> content;
  content.reserve(kRawSize * cuboids.size());
  for (int axis = 0; axis < 3; ++axis) {
    std::uint32_t before = 0;
    append_planes<std::uint32_t>(content, cuboids.size(), [&](std::size_t i) {
      const auto min = static_cast<std::uint32_t>(cuboids[i].cells.min[axis]);
      return zigzag(min - std::exchange(before, min));
    });
  }
  for (int axis = 0; axis < 3; ++axis) {
    append_planes<std::uint32_t>(content, cuboids.size(), [&](std::size_t i) {
      return static_cast<std::uint32_t>(cuboids[i].cells.extent()[axis] - 1);
    });
  }
  append_planes<std::uint64_t>(content, cuboids.size(),
                               [&](std::size_t i) { return cuboids[i].points; });
  return content;
}

class RcsReader {
 public:
  explicit RcsReader(const std::filesystem::path& file)
      : bytes_(InputFile(file).read_rest()), reader_(file, bytes_) {}

  CuboidList read() {
    verify();
    const auto version = reader_.number<std::uint32_t>("the version");
    if (version != kVersion) {
      throw error(
          fmt::format("is in version {} of the rcs format: this release of rmap reads "
                      "version {}",
                      version, kVersion));
    }
    const auto flags = reader_.number<std::uint32_t>("the flags");
    if ((flags & ~kCompressed) != 0) {
      throw error(
          fmt::format("has flags {:#x}: version {} knows {:#x}", flags, kVersion, kCompressed));
    }
    CuboidList list;
    read_frame(list);
    const auto count = reader_.number<std::uint64_t>("the number of cuboids");
    decode(content(count, (flags & kCompressed) != 0), list.cuboids);
    return list;
  }

 private:
  // Magic and checksum, which have their places in all versions.
  void verify() {
    const auto same = [](unsigned char a, std::byte b) { return std::byte{a} == b; };
    if (bytes_.size() < kMagic.size() ||
        !std::equal(kMagic.begin(), kMagic.end(), bytes_.begin(), same)) {
      throw error(
          fmt::format("is not an rcs file, or damaged: its first {} bytes are not those "
                      "that every rcs file begins with",
                      kMagic.size()));
    }
    if (bytes_.size() < kFrameSize + wire::kChecksumSize) {
      throw error(fmt::format("is cut off: it has {} bytes, and an rcs file has at least {}",
                              bytes_.size(), kFrameSize + wire::kChecksumSize));
    }
    const std::size_t end = bytes_.size() - wire::kChecksumSize;
    RmapChecksum checksum;
    checksum.update(std::span(bytes_).first(end));
    if (load_little<std::uint64_t>(&bytes_[end]) != checksum.close()) {
      throw error("is damaged: its checksum does not fit its bytes");
    }
    reader_ = ByteReader(reader_.file(), std::span(bytes_).first(end));
    reader_.take(kMagic.size(), "the magic");
  }

  void read_frame(CuboidList& list) {
    try {
      list.resolution = Lattice(reader_.number<double>("the resolution")).resolution();
      std::vector<Pose> poses;
      wire::decode_poses(reader_.take(wire::kPoseSize, "the frame"), wire::kPoseSize, poses);
      list.frame = poses.front();
    } catch (const Error& wrong) {
      throw error(fmt::format("has no sound header: {}", wrong.what()));
    }
  }

  // The columns of `count` cuboids; the count is believed when the file is long enough for it.
  std::span<const std::byte> content(std::uint64_t count, bool compressed) {
    const std::size_t stored_size = reader_.remaining();
    const std::size_t each = compressed ? kLeastSize : kRawSize;
    if (count > stored_size / each || (!compressed && count * kRawSize != stored_size)) {
      throw error(
          fmt::format("announces {} cuboids, which do not fit the {} bytes that it has for "
                      "them",
                      count, stored_size));
    }
    const auto stored = reader_.take(stored_size, "the cuboids");
    if (!compressed) return stored;
    raw_.resize(static_cast<std::size_t>(count) * kRawSize);
    if (!Decompressor().decompress(stored, raw_)) {
      throw error(
          fmt::format("does not decompress: it must hold one zstd frame of {} bytes, "
                      "followed by zeros",
                      raw_.size()));
    }
    return raw_;
  }

  void decode(std::span<const std::byte> content, std::vector<Cuboid>& cuboids) const {
    const std::size_t count = content.size() / kRawSize;
    cuboids.resize(count);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto mins = content.subspan(4 * count * axis, 4 * count);
      const auto extents = content.subspan(4 * count * (axis + 3), 4 * count);
      std::uint32_t min = 0;
      for (std::size_t i = 0; i < count; ++i) {
        min += unzigzag(from_planes<std::uint32_t>(mins, i));
        const auto low = static_cast<std::int32_t>(min);
        const std::int64_t high = std::int64_t{low} + from_planes<std::uint32_t>(extents, i) + 1;
        if (low < kMinCellIndex || high > std::int64_t{kMaxCellIndex} + 1) {
          throw error(
              fmt::format("holds cuboid {} from {} to {} on axis {}, which is beyond the "
                          "limits of cell indices",
                          i, low, high, "xyz"[axis]));
        }
        cuboids[i].cells.min[static_cast<int>(axis)] = low;
        cuboids[i].cells.max[static_cast<int>(axis)] = static_cast<std::int32_t>(high);
      }
    }
    const auto points = content.subspan(24 * count);
    for (std::size_t i = 0; i < count; ++i) {
      cuboids[i].points = from_planes<std::uint64_t>(points, i);
    }
  }

  Error error(std::string_view predicate) const {
    return {ErrorKind::input, fmt::format("{} {}", reader_.file().string(), predicate)};
  }

  std::vector<std::byte> bytes_;
  std::vector<std::byte> raw_;
  ByteReader reader_;
};

}  // namespace

void write_cuboid_rcs(AtomicFile& file, const CuboidList& list) {
  const std::vector<std::byte> content = encoded(list.cuboids);
  Compressor compressor;
  std::span<const std::byte> stored = content;
  const auto frame = compressor.compress(content);
  const std::size_t least = kLeastSize * list.cuboids.size();
  const bool compressed = frame.has_value();
  if (compressed) stored = *frame;

  std::vector<std::byte> start;
  for (const unsigned char byte : kMagic) wire::append(start, byte);
  wire::append(start, kVersion);
  wire::append(start, compressed ? kCompressed : 0U);
  wire::append(start, list.resolution);
  const auto pose = wire::encoded_poses(std::span(&list.frame, 1));
  start.insert(start.end(), pose.begin(), pose.end());
  wire::append(start, static_cast<std::uint64_t>(list.cuboids.size()));

  const std::vector<std::byte> padding(std::max(stored.size(), least) - stored.size());
  RmapChecksum checksum;
  for (const std::span<const std::byte> part :
       {std::span<const std::byte>(start), stored, std::span<const std::byte>(padding)}) {
    checksum.update(part);
    file.write(part);
  }
  file.write(little_endian(checksum.close()));
}

CuboidList read_cuboid_rcs(const std::filesystem::path& file) { return RcsReader(file).read(); }

}  // namespace rmap
