#pragma once

#include "io/bytes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <rmap/leaf.hpp>

// What lies in a `.rmap` file, byte for byte, apart from how it lies in memory.
// docs/formats/rmap.md says it in words.
namespace rmap::wire {

/// The version of header and chunks that this release writes and reads.
inline constexpr std::uint32_t kFormatVersion = 1;

/// Not text (first byte), and changed by whoever rewrites the ends of lines.
inline constexpr std::array<unsigned char, 8> kMagic = {0x89, 'R', 'M', 'A', 'P', '\r', '\n', '\n'};

using ChunkType = std::array<char, 4>;

inline constexpr ChunkType kOptions = {'O', 'P', 'T', 'S'};
inline constexpr ChunkType kHistory = {'H', 'I', 'S', 'T'};
inline constexpr ChunkType kPoses = {'P', 'O', 'S', 'E'};
inline constexpr ChunkType kCells = {'C', 'E', 'L', 'L'};
inline constexpr ChunkType kEnd = {'E', 'N', 'D', ' '};
/// Kept for records of observations and for cuboids; not in use yet.
inline constexpr ChunkType kObservations = {'O', 'B', 'S', 'V'};
inline constexpr ChunkType kCuboids = {'C', 'U', 'B', 'O'};

/// A reader that does not know the chunk must refuse the file.
inline constexpr std::uint16_t kRequired = 1;
/// The content is one frame of zstd; zeros fill it up to the least size of its kind.
inline constexpr std::uint16_t kCompressed = 2;

inline constexpr std::size_t kHeaderSize = 40;
inline constexpr std::size_t kChunkHeaderSize = 24;
inline constexpr std::size_t kChecksumSize = 8;

inline constexpr std::size_t kOptionsSize = 10 * sizeof(double) + 2 * sizeof(std::uint32_t);
inline constexpr std::size_t kPoseSize = 12 * sizeof(double);
inline constexpr std::size_t kMaxPosesPerChunk = 32768;
inline constexpr std::size_t kMaxBlocksPerChunk = 4096;

/// Largest content of a chunk that this release knows, decompressed: that of full
/// blocks, each with its indices, the summary of its mask, the mask and the values.
inline constexpr std::size_t kMaxContentSize =
    8 + kMaxBlocksPerChunk * (12 + 8 + kBlockCells / 8 + kBlockCells * sizeof(Value));
static_assert(kMaxPosesPerChunk * kPoseSize <= kMaxContentSize);

/// What poses and blocks take in the file at least, however well they compress: it
/// bounds the memory for a map by the length of its file, to less than twenty times.
inline std::uint64_t least_size_of_poses(std::uint64_t poses) { return 10 * poses; }
inline std::uint64_t least_size_of_blocks(std::uint64_t blocks, std::uint64_t cells) {
  return 10 * blocks + (cells + 7) / 8;
}

/// What the file begins with; its checksum follows.
struct Header {
  std::uint32_t version = kFormatVersion;
  std::uint64_t scans = 0;
  std::uint64_t blocks = 0;
  std::uint64_t cells = 0;
};

/// What a chunk begins with; its content and its checksum follow.
struct ChunkHeader {
  ChunkType type = {};
  std::uint16_t flags = 0;
  /// Format version that a reader must know to read the chunk.
  std::uint16_t version = kFormatVersion;
  std::uint64_t raw_size = 0;     ///< of the content, decompressed
  std::uint64_t stored_size = 0;  ///< of the content, as it is in the file

  bool required() const { return (flags & kRequired) != 0; }
  bool compressed() const { return (flags & kCompressed) != 0; }
};

/// A chunk's type for messages: without trailing blanks, unprintable bytes as hex.
std::string name_of(const ChunkType& type);

std::vector<std::byte> encoded(const Header& header);
std::vector<std::byte> encoded(const ChunkHeader& header);
/// The fields behind the magic, which is not looked at.
Header decoded_header(std::span<const std::byte, kHeaderSize> bytes);
ChunkHeader decoded_chunk_header(std::span<const std::byte, kChunkHeaderSize> bytes);

/// Appends the little-endian bytes of a number.
template <class T>
void append(std::vector<std::byte>& bytes, T number) {
  const auto raw = little_endian(number);
  // Not insert(): GCC 12 at -O3 takes its branch for a full vector for an overflow.
  for (const std::byte byte : raw) bytes.push_back(byte);
}

/// The same for a number of which both zeros mean the same: equal maps are equal bytes.
inline void append_without_negative_zero(std::vector<std::byte>& bytes, double number) {
  append(bytes, number == 0 ? 0.0 : number);
}

}  // namespace rmap::wire
