#pragma once

#include "io/atomic_file.hpp"
#include "io/rmap_checksum.hpp"
#include "io/rmap_compression.hpp"
#include "io/rmap_format.hpp"

namespace rmap {

/// Writes the header and the chunks of a `.rmap` file. All members throw Error(io).
class RmapWriter {
 public:
  RmapWriter(const std::filesystem::path& file, const wire::Header& header);

  /// Appends a chunk that readers must know, of at most wire::kMaxContentSize bytes,
  /// compressed where that makes it smaller, but not below `least_size` bytes.
  void add(const wire::ChunkType& type, std::span<const std::byte> content,
           std::uint64_t least_size = 0);

  /// Closes the file with the END chunk and gives it its name; the last call.
  void commit();

 private:
  void write_chunk(const wire::ChunkHeader& header, std::span<const std::byte> stored,
                   std::size_t padding);
  void write(std::span<const std::byte> bytes);
  void write_checksum();

  AtomicFile file_;
  RmapChecksum checksum_;
  Compressor compressor_;
  std::uint64_t chunks_ = 0;
};

}  // namespace rmap
