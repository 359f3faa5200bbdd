#pragma once

#include "io/input_file.hpp"
#include "io/rmap_checksum.hpp"
#include "io/rmap_content.hpp"
#include "io/rmap_format.hpp"

#include <optional>
#include <string_view>

#include <rmap/error.hpp>

namespace rmap {

/// Walks through the chunks of a `.rmap` file that may come from anybody. Sizes are
/// checked against the file before anything is read, and checksums before anything
/// is believed, so that damage is told from what is merely new. Memory: the content
/// of one chunk. All members throw Error(input) by the file's content, Error(io).
class RmapReader {
 public:
  struct Chunk {
    wire::ChunkHeader header;
    std::uint64_t offset;  ///< of its first byte in the file
  };

  /// Reads the header.
  explicit RmapReader(const std::filesystem::path& file);

  const wire::Header& header() const { return header_; }
  const std::filesystem::path& path() const { return file_.path(); }
  std::uint64_t file_size() const { return file_.size(); }

  /// The next chunk, whose content must then be read or skipped.
  Chunk next();
  /// The content of the chunk that next() gave, decompressed; valid until the next call.
  std::span<const std::byte> read(const Chunk& chunk);
  /// Passes over the content: only its checksum is verified.
  void skip(const Chunk& chunk);
  /// Reads the END chunk's content, which must be right, and the last of the file.
  void finish(const Chunk& end);

  /// Error(input): "<file>: chunk <type> at byte <offset> <what is wrong>".
  Error error(const Chunk& chunk, std::string_view wrong) const;

 private:
  void read_header();
  void read_stored(const Chunk& chunk);
  void verify_checksum(std::string_view whose);
  std::uint64_t remaining() const { return file_.size() - position_; }
  void read_bytes(std::span<std::byte> bytes);

  InputFile file_;
  std::uint64_t position_ = 0;
  RmapChecksum checksum_;
  wire::ContentDecoder decoder_;
  wire::Header header_;
  std::uint64_t chunks_ = 0;
  std::vector<std::byte> stored_;
};

}  // namespace rmap
