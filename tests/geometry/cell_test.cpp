#include "support/random.hpp"

#include <bitset>

#include <gtest/gtest.h>

#include <rmap/cell.hpp>

namespace rmap {
namespace {

// The Morton code packed bit by bit: 93 bits, x lowest.
std::bitset<93> packed(const Cell& cell) {
  std::bitset<93> code;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::bitset<31> index(
        static_cast<std::uint64_t>(std::int64_t{cell[static_cast<int>(axis)]} + (1 << 30)));
    for (std::size_t bit = 0; bit < 31; ++bit) code[3 * bit + axis] = index[bit];
  }
  return code;
}

bool packed_less(const Cell& a, const Cell& b) {
  const auto difference = packed(a) ^ packed(b);
  for (std::size_t bit = 93; bit-- > 0;) {
    if (difference[bit]) return packed(b)[bit];
  }
  return false;
}

TEST(MortonLess, EqualsTheOrderOfPackedCodes) {
  test::Random random(1);
  SCOPED_TRACE(random.trace());
  int cases = 0;
  for (const std::int32_t reach : {1, 2, 9, 1000, 1 << 29, 1 << 30}) {
    for (int i = 0; i < 3000; ++i) {
      Cell a = random.cell(-reach, reach - 1);
      Cell b = random.cell(-reach, reach - 1);
      if (random.chance(0.3)) b[random.integer(0, 2)] = a[random.integer(0, 2)];
      if (random.chance(0.1)) b = a;
      ASSERT_EQ(morton_less(a, b), packed_less(a, b)) << a.transpose() << " | " << b.transpose();
      ASSERT_EQ(morton_less(b, a), packed_less(b, a));
      ++cases;
    }
  }
  EXPECT_EQ(cases, 18000);
}

TEST(CellBox, VolumeCountsCells) {
  EXPECT_EQ((CellBox{.min = {0, 0, 0}, .max = {2, 3, 4}}).volume(), 24);
  EXPECT_EQ((CellBox{.min = {0, 0, 0}, .max = {2, 3, 0}}).volume(), 0);
  EXPECT_EQ((CellBox{.min = {0, 0, 5}, .max = {2, 3, 0}}).volume(), 0);
  EXPECT_EQ(all_cells().volume(), 0x1p93);
}

TEST(CellBox, ContainsAndOverlapsAgreeWithItsCells) {
  test::Random random(2);
  SCOPED_TRACE(random.trace());
  int overlapping = 0;
  int containing = 0;
  for (int i = 0; i < 2000; ++i) {
    const CellBox a = random.box(-3, 3, 4);
    const CellBox b = random.box(-3, 3, 3);
    int shared = 0;
    for (int x = b.min.x(); x < b.max.x(); ++x) {
      for (int y = b.min.y(); y < b.max.y(); ++y) {
        for (int z = b.min.z(); z < b.max.z(); ++z) shared += a.contains(Cell(x, y, z)) ? 1 : 0;
      }
    }
    ASSERT_EQ(a.overlaps(b), shared > 0);
    ASSERT_EQ(a.contains(b), shared == b.volume());
    ASSERT_EQ(intersection(a, b).volume(), shared);
    ASSERT_TRUE(united(a, b).contains(a) && united(a, b).contains(b));
    overlapping += a.overlaps(b) ? 1 : 0;
    containing += a.contains(b) ? 1 : 0;
  }
  EXPECT_GT(overlapping, 100);
  EXPECT_GT(containing, 5);
}

}  // namespace
}  // namespace rmap
