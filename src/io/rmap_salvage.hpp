#pragma once

#include "io/rmap_format.hpp"

#include <filesystem>
#include <optional>

#include <rmap/map_repair.hpp>

namespace rmap {

/// A chunk that its checksum confirms, in the bytes of a file.
struct SoundChunk {
  wire::ChunkHeader header;
  std::uint64_t offset;  ///< of its first byte in the file
  std::span<const std::byte> stored;

  /// "chunk CELL at byte 48".
  std::string place() const;
};

/// What checksums confirm of the bytes of a `.rmap` file.
struct Salvage {
  std::optional<wire::Header> header;  ///< nothing when it is damaged
  std::vector<SoundChunk> chunks;      ///< in the order of the file, END too
  std::vector<MapProblem> problems;    ///< the parts that nothing confirms
};

/// Finds all chunks that are intact, in bytes that may be anything. `file` is for messages. Throws
/// nothing but for lack of memory. Time: bounded by some times the number of bytes.
Salvage salvage(const std::filesystem::path& file, std::span<const std::byte> bytes);

}  // namespace rmap
