#pragma once

#include "io/file_descriptor.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

namespace rmap {

/// A regular file open for reading from its start to the end it had when opened.
/// Read, not mapped: a file that shrinks meanwhile is an error instead of a crash.
class InputFile {
 public:
  /// Throws Error(io) when the file cannot be opened, or is a folder, a pipe or a device.
  explicit InputFile(std::filesystem::path path);

  const std::filesystem::path& path() const { return path_; }
  /// Bytes when opened.
  std::uint64_t size() const { return size_; }

  /// Fills `buffer` with the bytes that follow those read so far. Throws Error(io) when
  /// reading fails or the file ends before.
  void read(std::span<std::byte> buffer);
  /// Passes over `count` bytes, at most as many as there are.
  void skip(std::uint64_t count) { position_ = std::min(size_, position_ + count); }
  /// All bytes that follow those read so far.
  std::vector<std::byte> read_rest();
  /// The first bytes of the file, `most` or as many as there are; read() does not notice.
  std::vector<std::byte> head(std::size_t most) const;
  /// Fills `buffer` with the bytes from `offset` on; read() does not notice. Throws as read().
  void read_at(std::uint64_t offset, std::span<std::byte> buffer) const;

 private:
  std::filesystem::path path_;
  FileDescriptor descriptor_;
  std::uint64_t size_ = 0;
  std::uint64_t position_ = 0;
};

}  // namespace rmap
