#include "support/random.hpp"

#include <array>

#include <gtest/gtest.h>

#include <rmap/packed_block.hpp>

namespace rmap {
namespace {

CellMask random_mask(test::Random& random) {
  CellMask mask;
  const double words = random.real(0, 1);
  const double density = random.chance(0.1) ? 1 : random.real(0, 0.5);
  for (std::uint32_t word = 0; word < 8; ++word) {
    if (!random.chance(words)) continue;
    for (std::uint32_t bit = 0; bit < 64; ++bit) {
      if (random.chance(density)) mask.set(64 * word + bit);
    }
  }
  return mask;
}

TEST(PackedBlock, HoldsTheCellsAndTheirValuesByRank) {
  test::Random random(81);
  SCOPED_TRACE(random.trace());
  for (int round = 0; round < 500; ++round) {
    const CellMask mask = random_mask(random);
    constexpr Value kUntouched = 12345;
    std::array<Value, packed_block::kMaxLength + 1> run;
    run.fill(kUntouched);
    packed_block::write_cells(run.data(), mask);
    Value* const values = packed_block::values(run.data());
    for (std::uint32_t i = 0; i < mask.count(); ++i) values[i] = static_cast<Value>(i);

    ASSERT_EQ(packed_block::cells(run.data()), mask);
    const Cell a = random.cell(0, kBlockEdge - 1);
    const Cell b = random.cell(0, kBlockEdge - 1);
    const CellsBetween box(a.cwiseMin(b), a.cwiseMax(b));
    ASSERT_EQ(packed_block::cells(run.data(), box), mask & box.mask());
    ASSERT_EQ(values + mask.count(), run.data() + packed_block::length(mask));
    ASSERT_EQ(run[packed_block::length(mask)], kUntouched);
    for (BlockPosition position = 0; position < kBlockCells; ++position) {
      const Value* const found = packed_block::find(run.data(), position);
      ASSERT_EQ(found != nullptr, mask.test(position));
      if (found != nullptr) {
        ASSERT_EQ(*found, static_cast<Value>(mask.rank(position)));
      }
    }
  }
}

TEST(PackedBlock, FewCellsAreShortAndAFullBlockIsTheLongest) {
  EXPECT_EQ(packed_block::length(CellMask::single(300)), 1 + 4 + 1U);
  CellMask full;
  for (BlockPosition position = 0; position < kBlockCells; ++position) full.set(position);
  EXPECT_EQ(packed_block::length(full), packed_block::kMaxLength);
}

}  // namespace
}  // namespace rmap
