#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <rmap/grid.hpp>

namespace rmap::test {

/// A chunk of a `.rmap` file as it is stored, right or wrong.
struct RawChunk {
  std::string type;
  std::string stored;
  std::uint64_t raw_size;
  std::uint16_t flags = 1;  ///< required
  std::uint16_t version = 1;

  friend bool operator==(const RawChunk&, const RawChunk&) = default;
};

/// A required chunk that is not compressed.
RawChunk raw_chunk(const std::string& type, const std::string& content);

/// A `.rmap` file in parts, right or wrong: the plain twin of the library's reader
/// and writer, made after docs/formats/rmap.md.
struct RawMap {
  std::uint64_t scans = 0;
  std::uint64_t blocks = 0;
  std::uint64_t cells = 0;
  std::vector<RawChunk> chunks = {};  ///< END too
  std::uint32_t version = 1;

  RawChunk& chunk(const std::string& type);

  friend bool operator==(const RawMap&, const RawMap&) = default;
};

/// The file's bytes, with the checksums that fit.
std::string bytes_of(const RawMap& map);

/// The parts of a file that is sound.
RawMap parsed(const std::string& bytes);

/// The same with the contents of all chunks decompressed.
RawMap decompressed(RawMap map);

/// What the file of a map must hold, not compressed.
RawMap raw_map(const Grid& grid);

/// Content of a POSE chunk.
std::string pose_bytes(const Pose& pose);

/// One zstd frame that holds `content`.
std::string zstd_frame(const std::string& content);

}  // namespace rmap::test
