#pragma once

#include <cassert>
#include <cstddef>
#include <memory>
#include <new>

namespace rmap {

/// Memory for arrays that live and die together, in one piece: a heap that gets
/// back many large pieces returns them to the system, and every scan would have
/// its pages cleared anew.
class Scratch {
 public:
  explicit Scratch(std::size_t bytes)
      : memory_(std::make_unique_for_overwrite<std::byte[]>(bytes)), bytes_(bytes) {}

  /// Bytes that an array takes.
  template <class T>
  static constexpr std::size_t bytes_for(std::size_t count) {
    return (count * sizeof(T) + kAlignment - 1) / kAlignment * kAlignment;
  }

  /// An array with unspecified content; what was taken before must leave room for it.
  template <class T>
  T* take(std::size_t count) {
    T* array = reinterpret_cast<T*>(memory_.get() + used_);
    used_ += bytes_for<T>(count);
    assert(used_ <= bytes_);
    std::uninitialized_default_construct_n(array, count);
    return array;
  }

 private:
  static constexpr std::size_t kAlignment = 64;

  std::unique_ptr<std::byte[]> memory_;
  [[maybe_unused]] std::size_t bytes_;  ///< for assertions
  std::size_t used_ = 0;
};

}  // namespace rmap
