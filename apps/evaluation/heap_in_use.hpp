#pragma once

#include <cstdint>

namespace rmap::evaluation {

/// Bytes that the program holds from the heap now, with what the allocator rounds up: the
/// difference of two calls is what lay between them. 0 where the C library cannot tell.
std::int64_t heap_in_use();

/// Has the heap put in order what others have freed, which it else does when the next one asks for
/// memory, in that one's time.
void settle_heap();

}  // namespace rmap::evaluation
