#include "approximation/bit_rows.hpp"

#include "support/random.hpp"

#include <set>
#include <vector>

#include <gtest/gtest.h>

#include <rmap/block.hpp>

namespace rmap {
namespace {

using test::Random;

// Lengths at which words of 64 places end.
constexpr std::int32_t kLengths[] = {3, 62, 63, 64, 65, 66, 126, 127, 128, 129, 130};

Cell size_with(int axis, std::int32_t length) {
  Cell size(5, 4, 6);
  size[axis] = length;
  return size;
}

TEST(BitRows, AreASetOfCells) {
  int compared = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (const std::int32_t length : kLengths) {
      Random random(static_cast<std::uint64_t>(length));
      SCOPED_TRACE(random.trace());
      const Cell size = size_with(axis, length);
      BitRows rows(size, axis);
      ASSERT_EQ(rows.size(), size);
      ASSERT_EQ(rows.axis(), axis);
      std::vector<bool> plain(static_cast<std::size_t>(size.prod()));
      const auto number = [&](const Cell& cell) {
        return static_cast<std::size_t>(cell.x() + size.x() * (cell.y() + size.y() * cell.z()));
      };
      for (int step = 0; step < 2000; ++step) {
        const Cell cell(random.integer(0, size.x() - 1), random.integer(0, size.y() - 1),
                        random.integer(0, size.z() - 1));
        const bool member = random.chance(0.6);
        member ? rows.set(cell) : rows.reset(cell);
        plain[number(cell)] = member;
      }
      for (std::int32_t z = 0; z < size.z(); ++z) {
        for (std::int32_t y = 0; y < size.y(); ++y) {
          for (std::int32_t x = 0; x < size.x(); ++x, ++compared) {
            ASSERT_EQ(rows.test({x, y, z}), plain[number({x, y, z})]);
          }
        }
      }
    }
  }
  EXPECT_EQ(compared, (4 * 6 + 5 * 6 + 5 * 4) * 963);
}

TEST(BitRows, RunsAreFoundAcrossWords) {
  int compared = 0;
  for (const std::int32_t length : kLengths) {
    for (const double density : {0.5, 0.9, 0.99, 1.0}) {
      Random random(static_cast<std::uint64_t>(length));
      SCOPED_TRACE(random.trace());
      BitRows rows({length, 3, 3}, 0);
      std::set<std::int32_t> plain;
      // The outermost cells stay out of the set.
      for (std::int32_t x = 1; x < length - 1; ++x) {
        if (random.chance(density)) {
          plain.insert(x);
          rows.set({x, 1, 1});
        }
      }
      for (const std::int32_t x : plain) {
        rmap::Run run{x, x};
        while (plain.contains(run.first - 1)) --run.first;
        while (plain.contains(run.last + 1)) ++run.last;
        ASSERT_EQ(run_around(rows.row({0, 1, 1}), x), run);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 2000);
}

TEST(BitRows, EveryRunIsAskedWordByWord) {
  constexpr std::int32_t kLength = 130;
  Random random(3);
  SCOPED_TRACE(random.trace());
  BitRows rows({kLength, 3, 3}, 0);
  for (std::int32_t x = 1; x < kLength - 1; ++x) {
    if (random.chance(0.97)) rows.set({x, 1, 1});
  }
  int compared = 0;
  for (std::int32_t first = 0; first < kLength; ++first) {
    bool all = true;
    std::uint32_t count = 0;
    for (std::int32_t last = first; last < kLength; ++last, ++compared) {
      all = all && rows.test({last, 1, 1});
      count += rows.test({last, 1, 1}) ? 1 : 0;
      ASSERT_EQ(row_holds(rows.row({0, 1, 1}), {first, last}), all);
      std::uint32_t counted = 0;
      BitRows::for_each_word({first, last}, [&](std::ptrdiff_t word, BitRows::Word mask) {
        counted += bit_count(rows.row({0, 1, 1})[word] & mask);
      });
      ASSERT_EQ(counted, count);
    }
  }
  EXPECT_EQ(compared, kLength * (kLength + 1) / 2);
}

TEST(BitRows, RunsIntersectAndContain) {
  EXPECT_EQ(intersection(rmap::Run{1, 5}, {3, 9}), (rmap::Run{3, 5}));
  EXPECT_TRUE((rmap::Run{1, 5}.contains({1, 5})));
  EXPECT_TRUE((rmap::Run{1, 5}.contains({2, 4})));
  EXPECT_FALSE((rmap::Run{1, 5}.contains({0, 4})));
  EXPECT_FALSE((rmap::Run{1, 5}.contains({2, 6})));
}

}  // namespace
}  // namespace rmap
