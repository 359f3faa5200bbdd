#include "evaluation/heap_in_use.hpp"

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

}  // namespace rmap::evaluation
