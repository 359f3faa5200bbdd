#pragma once

#include "io/file_descriptor.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace rmap {

/// A file that appears complete or not at all. Bytes go to a hidden temporary file
/// in the target's folder; commit() puts it in the target's place, and without
/// commit() it is removed: the target then is what it was before.
///
/// A symbolic link stays one: the file that it leads to is replaced. A file that is
/// replaced hands on its permissions; one that is write-protected is refused.
/// Devices, pipes and descriptors (/dev/stdout, /dev/full, /proc/self/fd/N) have no
/// place to put a complete file into: they are appended to as the bytes come.
///
/// A limit on the size of files (RLIMIT_FSIZE) ends the process with SIGXFSZ, and a
/// closed pipe with SIGPIPE, unless the program ignores these signals; then both are
/// errors like a full disk.
class AtomicFile {
 public:
  /// Throws Error(io) when the target cannot be written.
  explicit AtomicFile(std::filesystem::path target);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();

  /// Appends. Buffered: Error(io), for a full disk say, may come with a later call.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text))); }

  /// Replaces bytes that were written already, as a header whose counts are known at
  /// the end. Throws Error(io) for devices and pipes.
  void overwrite(std::uint64_t offset, std::span<const std::byte> bytes);
  void overwrite(std::uint64_t offset, std::string_view text) {
    overwrite(offset, std::as_bytes(std::span(text)));
  }

  /// Bytes appended so far.
  std::uint64_t size() const { return flushed_ + buffer_.size(); }
  const std::filesystem::path& target() const { return target_; }

  /// Brings the bytes to the disk and gives them the target's name; the last call.
  void commit();

 private:
  void open_temporary(const std::filesystem::path& destination);
  void flush();
  [[noreturn]] void fail(int code) const;

  std::filesystem::path target_;       ///< as named by the caller
  std::filesystem::path destination_;  ///< behind links; empty when written directly
  std::filesystem::path temporary_;    ///< empty when written directly, or when gone
  FileDescriptor descriptor_;
  std::vector<std::byte> buffer_;
  std::uint64_t flushed_ = 0;
};

}  // namespace rmap
