#pragma once

#include <cstddef>

#include <rmap/function_ref.hpp>

namespace rmap {

/// Number of threads that an option `threads` means: itself, or for 0 one for each core.
int thread_count(int threads);

/// Number of ranges into which for_each_range cuts [0, count); 1 for none.
std::size_t range_count(int threads, std::size_t count, std::size_t least = 1);

/// Cuts [0, count), unless it is empty, into range_count(threads, count, least) ranges of
/// about equal length, at most `threads` and none shorter than `least` if there are several,
/// and calls work(range, begin, end) for each, beside one another. Returns when all are done;
/// an exception from `work` is thrown on.
void for_each_range(int threads, std::size_t count, std::size_t least,
                    FunctionRef<void(std::size_t range, std::size_t begin, std::size_t end)> work);
inline void for_each_range(
    int threads, std::size_t count,
    FunctionRef<void(std::size_t range, std::size_t begin, std::size_t end)> work) {
  for_each_range(threads, count, 1, work);
}

}  // namespace rmap
