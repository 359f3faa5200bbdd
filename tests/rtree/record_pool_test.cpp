#include "support/random.hpp"

#include <cstdint>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <rmap/rtree/record_pool.hpp>

namespace rmap {
namespace {

using test::Random;

TEST(RecordPool, PagesAreSixteenKibibytesOfAPowerOfTwoRecords) {
  EXPECT_EQ(RecordPool<std::byte>(4).records_per_page(), 4096u);
  EXPECT_EQ(RecordPool<std::byte>(452).records_per_page(), 32u);
  EXPECT_EQ(RecordPool<std::int16_t>(512).records_per_page(), 16u);
  EXPECT_EQ(RecordPool<double>(2048).records_per_page(), 1u);
  EXPECT_EQ(RecordPool<double>(5000).records_per_page(), 1u);
}

TEST(RecordPool, AReleasedRecordIsUsedAgainFirst) {
  RecordPool<std::int32_t> pool(3);
  EXPECT_EQ(pool.allocate(), 0u);
  EXPECT_EQ(pool.allocate(), 1u);
  EXPECT_EQ(pool.allocate(), 2u);
  pool.release(0);
  pool.release(2);
  EXPECT_EQ(pool.size(), 1u);
  EXPECT_EQ(pool.slots(), 3u);
  EXPECT_EQ(pool.slots_in_use(), (std::vector<bool>{false, true, false}));
  EXPECT_EQ(pool.allocate(), 2u);
  EXPECT_EQ(pool.allocate(), 0u);
  EXPECT_EQ(pool.allocate(), 3u);
  EXPECT_EQ(pool.size(), 4u);
}

TEST(RecordPool, GrowthMovesNoRecord) {
  RecordPool<std::int64_t> pool(100);  // 16 records a page
  const auto first = pool.allocate();
  const std::int64_t* address = pool.record(first);
  for (int i = 0; i < 1000; ++i) pool.allocate();
  EXPECT_EQ(pool.record(first), address);
}

TEST(RecordPool, CountsAllItsMemory) {
  RecordPool<std::byte> pool(16384);
  EXPECT_EQ(pool.bytes_in_use(), 0u);
  pool.allocate();
  EXPECT_EQ(pool.bytes_in_use(), 16384 + sizeof(void*));
  const auto second = pool.allocate();
  pool.allocate();
  EXPECT_GE(pool.bytes_in_use(), 3 * (16384UL + sizeof(void*)));
  EXPECT_LE(pool.bytes_in_use(), 3UL * 16384 + 4 * sizeof(void*));
  const auto before = pool.bytes_in_use();
  pool.release(second);
  EXPECT_EQ(pool.bytes_in_use(), before);
  pool.clear();
  EXPECT_EQ(pool.bytes_in_use(), 0u);
  EXPECT_EQ(pool.slots(), 0u);
  EXPECT_EQ(pool.size(), 0u);
}

TEST(RecordPool, ReservedRecordsNeedNoMoreMemory) {
  RecordPool<std::byte> pool(8192);  // 2 records a page
  pool.reserve(5);
  const auto bytes = pool.bytes_in_use();
  for (int i = 0; i < 5; ++i) pool.allocate();
  EXPECT_EQ(pool.bytes_in_use(), bytes);
  pool.release(3);
  pool.release(1);
  pool.reserve(3);  // two free ones and the rest of the last page
  EXPECT_EQ(pool.bytes_in_use(), bytes);
}

TEST(RecordPool, RefusesMoreThanItsIdsCanName) {
  RecordPool<std::byte> pool(4);
  EXPECT_THROW(pool.reserve(std::size_t{1} << 32), Error);
  EXPECT_EQ(pool.bytes_in_use(), 0u);
}

TEST(RecordPool, EqualsAMapOfRecordsThroughRandomCalls) {
  Random random(1);
  SCOPED_TRACE(random.trace());
  RecordPool<std::int32_t> pool(300);
  std::map<std::uint32_t, std::int32_t> expected;
  int compared = 0;
  for (int i = 0; i < 3000; ++i) {
    if (expected.empty() || random.chance(0.55)) {
      const auto id = pool.allocate();
      ASSERT_EQ(expected.count(id), 0u);
      std::fill_n(pool.record(id), 300, i);
      expected[id] = i;
    } else {
      auto victim = expected.lower_bound(
          static_cast<std::uint32_t>(random.integer(0, static_cast<int>(pool.slots()) - 1)));
      if (victim == expected.end()) victim = expected.begin();
      pool.release(victim->first);
      expected.erase(victim);
    }
    ASSERT_EQ(pool.size(), expected.size());
  }
  const RecordPool<std::int32_t> copy = pool;
  const auto in_use = pool.slots_in_use();
  ASSERT_TRUE(in_use);
  EXPECT_EQ(copy.slots_in_use(), in_use);
  for (std::uint32_t id = 0; id < pool.slots(); ++id) {
    ASSERT_EQ((*in_use)[id], expected.count(id) == 1);
    if (!(*in_use)[id]) continue;
    ASSERT_EQ(pool.record(id)[0], expected[id]);
    ASSERT_EQ(pool.record(id)[299], expected[id]);
    ASSERT_EQ(copy.record(id)[150], expected[id]);
    ++compared;
  }
  EXPECT_EQ(compared, static_cast<int>(expected.size()));
  EXPECT_GT(compared, 100);
}

TEST(RecordPool, ACopyIsIndependentAndAMoveLeavesAnEmptyPool) {
  RecordPool<std::int32_t> pool(4);
  const auto a = pool.allocate();
  const auto b = pool.allocate();
  pool.record(a)[0] = 1;
  pool.record(b)[0] = 2;

  RecordPool<std::int32_t> copy = pool;
  copy.record(a)[0] = 10;
  copy.release(b);
  EXPECT_EQ(pool.record(a)[0], 1);
  EXPECT_EQ(pool.size(), 2u);

  RecordPool<std::int32_t> moved = std::move(pool);
  EXPECT_EQ(moved.record(b)[0], 2);
  // NOLINTNEXTLINE(bugprone-use-after-move,clang-analyzer-cplusplus.Move): documented to be empty
  EXPECT_EQ(pool.size(), 0u);
  EXPECT_EQ(pool.slots(), 0u);
  EXPECT_EQ(pool.allocate(), 0u);

  pool = copy;
  EXPECT_EQ(pool.record(a)[0], 10);
  EXPECT_EQ(pool.allocate(), b);
  pool = std::move(moved);
  EXPECT_EQ(pool.record(b)[0], 2);
  static_assert(std::is_nothrow_move_constructible_v<RecordPool<int>>);
  static_assert(std::is_nothrow_move_assignable_v<RecordPool<int>>);
}

TEST(RecordPool, FindsADamagedListOfFreeRecords) {
  const auto with_link = [](std::uint32_t link) {
    RecordPool<std::uint32_t> pool(1);
    for (int i = 0; i < 4; ++i) pool.allocate();
    pool.release(1);
    pool.release(2);  // 2 -> 1 -> end
    *pool.record(2) = link;
    return pool.slots_in_use();
  };
  EXPECT_TRUE(with_link(1));
  EXPECT_FALSE(with_link(2));           // a circle
  EXPECT_FALSE(with_link(4));           // outside
  EXPECT_FALSE(with_link(0xFFFFFFFF));  // too short
}

}  // namespace
}  // namespace rmap
