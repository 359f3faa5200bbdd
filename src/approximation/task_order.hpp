#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <rmap/function_ref.hpp>

namespace rmap {

/// Runs task(i) for each i, beside one another on up to `threads` threads (0: one for each core),
/// none before all tasks in before[i], which have smaller numbers, are done. An exception from a
/// task is thrown on, and what has not begun by then is left out.
void run_in_order(int threads, std::span<const std::vector<std::size_t>> before,
                  FunctionRef<void(std::size_t)> task);

}  // namespace rmap
