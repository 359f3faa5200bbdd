#include "evaluation/heap_in_use.hpp"

#include <cstdlib>
#include <malloc.h>

namespace rmap::evaluation {

std::int64_t heap_in_use() {
#ifdef __GLIBC__
  const struct mallinfo2 info = mallinfo2();
  return static_cast<std::int64_t>(info.uordblks + info.hblkhd);
#else
  return 0;
#endif
}

void settle_heap() {
  // A request of this size joins small free pieces, and sorts some thousands of them.
  constexpr std::size_t kLarge = 4096;
  constexpr int kRequests = 256;
  for (int i = 0; i < kRequests; ++i) {
    void* volatile piece = std::malloc(kLarge);
    std::free(piece);
  }
}

}  // namespace rmap::evaluation
