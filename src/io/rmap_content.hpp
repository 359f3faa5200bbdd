#pragma once

#include "io/rmap_compression.hpp"
#include "io/rmap_format.hpp"

namespace rmap::wire {

/// Makes the content of a chunk of what is stored. Memory: one content.
class ContentDecoder {
 public:
  /// The content, until the next call or the end of `stored`. The checksum of the chunk has been
  /// verified. Throws Error(input) with what is wrong as a predicate, for the reader to complete.
  std::span<const std::byte> decode(const ChunkHeader& header, std::span<const std::byte> stored);

 private:
  Decompressor decompressor_;
  std::vector<std::byte> content_;
};

}  // namespace rmap::wire
