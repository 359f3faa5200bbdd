#include "support/random.hpp"

#include <set>

#include <gtest/gtest.h>

#include <rmap/leaf.hpp>

namespace rmap {
namespace {

TEST(BlockPosition, FollowsTheMortonOrderOfCells) {
  for (const Cell& origin : {Cell(0, 0, 0), Cell(-8, 16, -800), Cell(kMinCellIndex, 0, 8)}) {
    Cell before = origin;
    for (BlockPosition position = 0; position < kBlockCells; ++position) {
      const Cell cell = origin + block_offset(position);
      ASSERT_EQ(block_position(cell), position);
      for (std::uint32_t axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(block_offset(position, axis), block_offset(position)[static_cast<int>(axis)]);
      }
      ASSERT_EQ(block_origin(cell), origin);
      ASSERT_TRUE(position == 0 || morton_less(before, cell));
      before = cell;
    }
  }
}

TEST(Block, CellsBetweenAreThoseWithTheirOffsetsBetween) {
  test::Random random(4);
  SCOPED_TRACE(random.trace());
  for (int round = 0; round < 300; ++round) {
    const Cell a = random.cell(0, kBlockEdge - 1);
    const Cell b = random.cell(0, kBlockEdge - 1);
    const Cell low = a.cwiseMin(b);
    const Cell high = a.cwiseMax(b);
    const CellMask mask = CellsBetween(low, high).mask();
    const CellBox box{low, high + Cell::Ones()};
    for (BlockPosition position = 0; position < kBlockCells; ++position) {
      ASSERT_EQ(mask.test(position), box.contains(block_offset(position)));
    }
  }
}

TEST(CellMask, IsASetOfPositions) {
  test::Random random(3);
  SCOPED_TRACE(random.trace());
  for (int round = 0; round < 200; ++round) {
    std::set<BlockPosition> a;
    std::set<BlockPosition> b;
    CellMask mask_a;
    CellMask mask_b;
    const int size = random.integer(0, 512);
    for (int i = 0; i < size; ++i) {
      const auto position = static_cast<BlockPosition>(random.integer(0, 511));
      if (random.chance(0.2)) {
        a.erase(position);
        mask_a.reset(position);
      } else {
        (random.chance(0.5) ? a : b).insert(position);
        (a.contains(position) && !b.contains(position) ? mask_a : mask_b).set(position);
        if (a.contains(position)) mask_a.set(position);
        if (b.contains(position)) mask_b.set(position);
      }
    }
    ASSERT_EQ(mask_a.count(), a.size());
    ASSERT_EQ(mask_a.none(), a.empty());
    std::vector<BlockPosition> listed;
    mask_a.for_each([&](BlockPosition position) { listed.push_back(position); });
    ASSERT_EQ(listed, std::vector<BlockPosition>(a.begin(), a.end()));
    std::uint32_t rank = 0;
    for (BlockPosition position = 0; position < kBlockCells; ++position) {
      const bool in_a = a.contains(position);
      const bool in_b = b.contains(position);
      ASSERT_EQ(mask_a.test(position), in_a);
      ASSERT_EQ(mask_a.rank(position), rank);
      ASSERT_EQ((mask_a & mask_b).test(position), in_a && in_b);
      ASSERT_EQ(mask_a.without(mask_b).test(position), in_a && !in_b);
      CellMask both = mask_a;
      both |= mask_b;
      ASSERT_EQ(both.test(position), in_a || in_b);
      rank += in_a ? 1 : 0;
    }
    std::size_t ranked = 0;
    (mask_a & mask_b).for_each_ranked(mask_a, [&](BlockPosition position, std::uint32_t place) {
      ASSERT_TRUE(a.contains(position) && b.contains(position));
      ASSERT_EQ(place, mask_a.rank(position));
      ++ranked;
    });
    ASSERT_EQ(ranked, (mask_a & mask_b).count());
    CellMask one;
    one.set(static_cast<BlockPosition>(round));
    ASSERT_EQ(CellMask::single(static_cast<BlockPosition>(round)), one);
  }
}

}  // namespace
}  // namespace rmap
