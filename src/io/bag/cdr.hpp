#pragma once

#include "io/bytes.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace rmap {

/// Walks through a message in CDR, the encoding of ROS 2, that nobody has checked yet: no step
/// leads beyond its end. Numbers are aligned to their size, counted from behind the four bytes
/// that say the byte order. The bytes outlive the reader.
///
/// Errors are Error(input) without the message's name: whoever knows it puts it before.
class CdrReader {
 public:
  /// Reads the four bytes at the start.
  explicit CdrReader(std::span<const std::byte> message);

  /// The next number, which is `what`.
  template <class T>
  T number(std::string_view what) {
    const std::byte* bytes = aligned(sizeof(T), sizeof(T), what).data();
    return big_endian_ ? load_big<T>(bytes) : load_little<T>(bytes);
  }

  /// A text, without the zero at its end.
  std::string_view text(std::string_view what);
  /// The number of elements that follow, of which each takes at least `least_size` bytes.
  std::uint32_t count(std::size_t least_size, std::string_view what);
  /// A sequence of bytes.
  std::span<const std::byte> bytes(std::string_view what);

 private:
  std::span<const std::byte> aligned(std::size_t alignment, std::uint64_t size,
                                     std::string_view what);
  std::size_t remaining() const { return content_.size() - position_; }

  std::span<const std::byte> content_;  ///< behind the four bytes
  std::size_t position_ = 0;
  std::size_t most_alignment_ = 8;
  bool big_endian_ = false;
};

}  // namespace rmap
