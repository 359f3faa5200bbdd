#pragma once

#include <cstddef>

namespace rmap::bench {

/// Counts what the program holds from operator new, with the allocator's rounding.
/// Only while it lives: uncounted, new and delete cost as ever. One at a time; memory
/// that was taken before must not be given back meanwhile.
class HeapCount {
 public:
  HeapCount();
  HeapCount(const HeapCount&) = delete;
  HeapCount& operator=(const HeapCount&) = delete;
  ~HeapCount();

  /// Bytes held now of what was taken since the start.
  std::size_t in_use() const;
  /// The most that was held at a time.
  std::size_t peak() const;
};

}  // namespace rmap::bench
