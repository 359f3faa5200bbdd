#include "grid/parallel.hpp"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace rmap {
namespace {

TEST(ForEachRange, CoversEachIndexOnce) {
  for (const int threads : {0, 1, 2, 3, 8}) {
    for (const std::size_t count : {0u, 1u, 2u, 7u, 8u, 1000u}) {
      std::vector<std::atomic<int>> visits(count);
      std::atomic<std::size_t> ranges = 0;
      for_each_range(threads, count, [&](std::size_t range, std::size_t begin, std::size_t end) {
        ++ranges;
        EXPECT_LT(range, static_cast<std::size_t>(thread_count(threads)));
        EXPECT_LT(begin, end);
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      for (const auto& visit : visits) EXPECT_EQ(visit, 1);
      EXPECT_EQ(ranges, std::min(count, static_cast<std::size_t>(thread_count(threads))));
    }
  }
}

TEST(ForEachRange, ThrowsOnWhatTheWorkThrows) {
  for (const int threads : {1, 3}) {
    EXPECT_THROW(for_each_range(threads, 10,
                                [](std::size_t, std::size_t, std::size_t end) {
                                  if (end == 10) throw std::runtime_error("the last one");
                                }),
                 std::runtime_error);
  }
}

}  // namespace
}  // namespace rmap
