#include "approximation/task_order.hpp"

#include "support/random.hpp"

#include <atomic>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

std::vector<std::vector<std::size_t>> random_order(Random& random, std::size_t count) {
  std::vector<std::vector<std::size_t>> before(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (random.chance(0.08)) before[i].push_back(j);
    }
  }
  return before;
}

TEST(TaskOrder, RunsEachTaskOnceAndAfterThoseBefore) {
  int compared = 0;
  for (const int threads : {0, 1, 2, 8}) {
    for (const std::size_t count : {0, 1, 2, 3, 7, 150}) {
      Random random(count);
      SCOPED_TRACE(random.trace());
      const auto before = random_order(random, count);
      for (int round = 0; round < 20; ++round, ++compared) {
        std::vector<std::atomic<int>> done(count);
        std::atomic<int> early = 0;
        run_in_order(threads, before, [&](std::size_t i) {
          for (const std::size_t j : before[i]) early += done[j] == 1 ? 0 : 1;
          ++done[i];
        });
        ASSERT_EQ(early, 0);
        for (const auto& times : done) ASSERT_EQ(times, 1);
      }
    }
  }
  EXPECT_EQ(compared, 4 * 6 * 20);
}

TEST(TaskOrder, OneThreadTakesThemInTheirOrder) {
  Random random(1);
  SCOPED_TRACE(random.trace());
  std::vector<std::size_t> order;
  run_in_order(1, random_order(random, 40), [&](std::size_t i) { order.push_back(i); });
  ASSERT_EQ(order.size(), 40u);
  for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(order[i], i);
}

TEST(TaskOrder, ThrowsOnAndBeginsNothingBehindTheFailure) {
  int thrown = 0;
  for (const int threads : {1, 2, 8}) {
    for (std::size_t bad = 0; bad < 30; bad += 7, ++thrown) {
      std::vector<std::vector<std::size_t>> before(30);  // a chain
      for (std::size_t i = 1; i < before.size(); ++i) before[i].push_back(i - 1);
      std::atomic<std::size_t> begun = 0;
      EXPECT_THROW(run_in_order(threads, before,
                                [&](std::size_t i) {
                                  ++begun;
                                  if (i == bad) throw std::runtime_error("bad");
                                }),
                   std::runtime_error);
      EXPECT_EQ(begun, bad + 1);
    }
    // All of them, at once.
    const std::vector<std::vector<std::size_t>> before(30);
    EXPECT_THROW(
        run_in_order(threads, before, [](std::size_t) { throw std::runtime_error("bad"); }),
        std::runtime_error);
  }
  EXPECT_EQ(thrown, 3 * 5);
}

}  // namespace
}  // namespace rmap
