#pragma once

#include <cstddef>

#include <rmap/function_ref.hpp>

namespace rmap {

/// Number of threads that an option `threads` means: itself, or for 0 one for each core.
int thread_count(int threads);

/// Cuts [0, count) into at most `threads` ranges of about equal length and calls
/// work(range, begin, end) for each, beside one another. Returns when all
/// are done; an exception from `work` is thrown on.
void for_each_range(int threads, std::size_t count,
                    FunctionRef<void(std::size_t range, std::size_t begin, std::size_t end)> work);

}  // namespace rmap
