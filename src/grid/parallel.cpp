#include "grid/parallel.hpp"

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

#ifndef RMAP_PARALLEL_JTHREAD
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#endif

namespace rmap {

namespace {

// Runs task(0) to task(tasks - 1) beside one another.
void run_tasks(std::size_t tasks, FunctionRef<void(std::size_t)> task) {
#ifdef RMAP_PARALLEL_JTHREAD
  // For the thread sanitizer, which knows std::jthread but not a library that it did not build.
  std::vector<std::exception_ptr> errors(tasks);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < tasks; ++i) {
      threads.emplace_back([&, i] {
        try {
          task(i);
        } catch (...) {
          errors[i] = std::current_exception();
        }
      });
    }
  }
  for (const auto& error : errors) {
    if (error) std::rethrow_exception(error);
  }
#else
  // More threads than cores would be slower, and oneTBB would warn on stderr.
  oneapi::tbb::task_arena arena(
      std::min(static_cast<int>(tasks), oneapi::tbb::info::default_concurrency()));
  arena.execute(
      [&] { oneapi::tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t i) { task(i); }); });
#endif
}

}  // namespace

int thread_count(int threads) {
  if (threads > 0) return threads;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

std::size_t range_count(int threads, std::size_t count, std::size_t least) {
  const auto most = static_cast<std::size_t>(thread_count(threads));
  return std::min(most, std::max<std::size_t>(count / least, 1));
}

void for_each_range(int threads, std::size_t count, std::size_t least,
                    FunctionRef<void(std::size_t, std::size_t, std::size_t)> work) {
  if (count == 0) return;
  const std::size_t ranges = range_count(threads, count, least);
  const auto border = [&](std::size_t range) {
    return count / ranges * range + std::min(range, count % ranges);
  };
  if (ranges == 1) {
    work(0, 0, count);
  } else {
    run_tasks(ranges, [&](std::size_t range) { work(range, border(range), border(range + 1)); });
  }
}

}  // namespace rmap
