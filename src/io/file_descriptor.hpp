#pragma once

#include <unistd.h>
#include <utility>

namespace rmap {

/// Owns an open descriptor, or none (-1).
class FileDescriptor {
 public:
  explicit FileDescriptor(int value = -1) : value_(value) {}
  FileDescriptor(FileDescriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}
  FileDescriptor& operator=(FileDescriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~FileDescriptor() {
    if (value_ >= 0) ::close(value_);
  }

  int get() const { return value_; }
  bool valid() const { return value_ >= 0; }
  /// Gives the descriptor up to the caller, who closes it.
  int release() { return std::exchange(value_, -1); }

 private:
  int value_;
};

}  // namespace rmap
