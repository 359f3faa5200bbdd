#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace rmap {

/// The CRC-32 of MCAP files (that of zlib and PNG too), of bytes that come in parts.
class Crc32 {
 public:
  void add(std::span<const std::byte> bytes);
  std::uint32_t value() const { return ~state_; }

 private:
  std::uint32_t state_ = 0xFFFFFFFF;
};

std::uint32_t crc32(std::span<const std::byte> bytes);

}  // namespace rmap
