#include "grid/value_pool.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace rmap {
namespace {

struct Lease {
  ValuePool::Handle handle;
  std::vector<Value> content;
};

bool holds(const ValuePool& pool, const Lease& run) {
  return std::equal(run.content.begin(), run.content.end(), pool.at(run.handle));
}

TEST(ValuePool, RunsKeepTheirContent) {
  test::Random random(5);
  SCOPED_TRACE(random.trace());
  ValuePool pool;
  std::vector<Lease> runs;
  std::size_t live = 0;
  for (int step = 0; step < 20000; ++step) {
    if (runs.empty() || random.chance(0.55)) {
      const int length = random.chance(0.8) ? random.integer(1, 40) : random.integer(1, 512);
      Lease run{pool.allocate(static_cast<std::uint32_t>(length)), {}};
      for (int i = 0; i < length; ++i) {
        run.content.push_back(static_cast<Value>(random.integer(-32768, 32767)));
      }
      std::copy(run.content.begin(), run.content.end(), pool.at(run.handle));
      live += run.content.size();
      runs.push_back(std::move(run));
    } else {
      std::swap(
          runs[static_cast<std::size_t>(random.integer(0, static_cast<int>(runs.size()) - 1))],
          runs.back());
      ASSERT_TRUE(holds(pool, runs.back()));
      pool.release(runs.back().handle, static_cast<std::uint32_t>(runs.back().content.size()));
      live -= runs.back().content.size();
      runs.pop_back();
    }
  }
  for (const Lease& run : runs) ASSERT_TRUE(holds(pool, run));
  const ValuePool copy = pool;
  std::fill_n(pool.at(runs.front().handle), runs.front().content.size(), Value{1});
  for (const Lease& run : runs) ASSERT_TRUE(holds(copy, run));
  // All that is neither live nor listed as free: granules' ends and the last page.
  EXPECT_LT(pool.bytes_in_use(), (live + pool.free_values()) * sizeof(Value) + runs.size() * 6 +
                                     3UL * 16384 + pool.bytes_in_use() / 512);
}

TEST(ValuePool, UsesFreedMemoryAgain) {
  ValuePool pool;
  std::vector<ValuePool::Handle> runs;
  for (int i = 0; i < 1000; ++i) runs.push_back(pool.allocate(64));
  const std::size_t before = pool.bytes_in_use();
  for (const auto run : runs) pool.release(run, 64);
  // Shorter runs are cut from longer ones that were freed.
  for (int i = 0; i < 4000; ++i) pool.allocate(16);
  EXPECT_EQ(pool.bytes_in_use(), before);
}

}  // namespace
}  // namespace rmap
