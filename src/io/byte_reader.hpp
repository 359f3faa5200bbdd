#pragma once

#include "io/bytes.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>

namespace rmap {

/// Walks through the bytes of a file that nobody has checked yet: no step leads
/// beyond the end. The bytes outlive the reader.
class ByteReader {
 public:
  /// `first_offset`: where in the file the bytes begin, for messages.
  ByteReader(const std::filesystem::path& file, std::span<const std::byte> bytes,
             std::uint64_t first_offset = 0)
      : file_(file), bytes_(bytes), first_offset_(first_offset) {}

  /// Offset in the file of the next byte.
  std::uint64_t offset() const { return first_offset_ + position_; }
  std::size_t remaining() const { return bytes_.size() - position_; }
  const std::filesystem::path& file() const { return file_; }

  /// The next `count` bytes, which are `what`. Throws Error(input) when fewer are left;
  /// any `count` is safe to ask for.
  std::span<const std::byte> take(std::uint64_t count, std::string_view what);

  /// The next little-endian number, which is `what`.
  template <class T>
  T number(std::string_view what) {
    return load_little<T>(take(sizeof(T), what).data());
  }

 private:
  std::filesystem::path file_;
  std::span<const std::byte> bytes_;
  std::uint64_t first_offset_;
  std::size_t position_ = 0;
};

}  // namespace rmap
