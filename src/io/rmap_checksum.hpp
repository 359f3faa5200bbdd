#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

struct XXH3_state_s;

namespace rmap {

/// The checksums of a `.rmap` file, XXH3 with 64 bits. Each covers all bytes from the
/// checksum before it (inclusive) to itself: contents, sizes and the order of chunks.
class RmapChecksum {
 public:
  RmapChecksum();

  /// Takes in the bytes of the file that follow.
  void update(std::span<const std::byte> bytes);
  /// The checksum that stands behind all bytes so far. It is taken in as well: the
  /// next one begins with it.
  std::uint64_t close();

 private:
  struct Free {
    void operator()(XXH3_state_s* state) const;
  };

  std::unique_ptr<XXH3_state_s, Free> state_;
};

}  // namespace rmap
