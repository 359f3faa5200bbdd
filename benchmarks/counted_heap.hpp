#pragma once

#include <cstddef>

namespace rmap::bench {

/// Bytes that the program holds from operator new just now, with the allocator's
/// rounding, and the most it has held. Every new and delete of the program is counted.
struct HeapUse {
  std::size_t taken = 0;
  std::size_t peak = 0;
};

HeapUse heap_use();
/// Starts a new peak at what is held now.
void reset_heap_peak();

}  // namespace rmap::bench
