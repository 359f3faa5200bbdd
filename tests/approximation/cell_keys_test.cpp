#include "approximation/cell_keys.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <tuple>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

TEST(CellKeys, SortAsCellsDo) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    // 2^21 along each axis are the most.
    const CellBox box = random.box(-1'000'000, 1'000'000, seed % 2 == 0 ? 5 : 1'000'000);
    const auto keys = CellKeys::of(box);
    ASSERT_TRUE(keys);
    const auto by_scan = [](const Cell& cell) { return std::tuple(cell.z(), cell.y(), cell.x()); };
    const auto random_cell = [&] {
      Cell cell;
      for (int axis = 0; axis < 3; ++axis) {
        cell[axis] = static_cast<int>(random.integer(box.min[axis], box.max[axis] - 1));
      }
      return cell;
    };
    for (int i = 0; i < 100; ++i, ++compared) {
      const Cell a = random_cell();
      const Cell b = random_cell();
      ASSERT_EQ(keys->cell(keys->key(a)), a);
      ASSERT_EQ(keys->key(a) < keys->key(b), by_scan(a) < by_scan(b));
      ASSERT_EQ(keys->key(a) >> keys->bits(), 0U);
    }
    ASSERT_EQ(keys->key(box.min), 0U);
  }
  EXPECT_EQ(compared, 10'000);
}

TEST(CellKeys, NeedABoxOfFewBits) {
  EXPECT_EQ(CellKeys::of(box_of(Cell(7, -8, 9)))->bits(), 0);
  EXPECT_EQ(CellKeys::of({.min = {0, 0, 0}, .max = {1 << 21, 1 << 21, 1 << 21}})->bits(), 63);
  EXPECT_FALSE(CellKeys::of({.min = {0, 0, 0}, .max = {1 << 22, 1 << 21, 1 << 21}}));
  EXPECT_FALSE(CellKeys::of(all_cells()));
}

TEST(CellKeys, SortLikeTheStandardLibrary) {
  int compared = 0;
  for (const int bits : {0, 1, 10, 11, 12, 33, 63}) {
    for (const std::size_t count : {0U, 1U, 5U, 2047U, 2048U, 10'000U}) {
      Random random(count + static_cast<std::uint64_t>(bits));
      SCOPED_TRACE(random.trace());
      std::vector<std::uint64_t> keys(count);
      for (auto& key : keys) key = random.engine()() & ((std::uint64_t{1} << bits) - 1);
      std::vector<std::uint64_t> plain = keys;
      std::sort(plain.begin(), plain.end());
      std::vector<std::uint64_t> spare;
      sort_keys(keys, bits, spare);
      ASSERT_EQ(keys, plain);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 42);
}

}  // namespace
}  // namespace rmap
