#include "approximation/block_masks.hpp"

#include "approximation/plain_cells.hpp"
#include "support/random.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

TEST(BlockMasks, AreASetThatChanges) {
  int compared = 0;
  for (const Cell& center : {Cell(0, 0, 0), Cell(-4000, 9000, 77), Cell(1 << 29, -(1 << 29), 5)}) {
    Random random(static_cast<std::uint64_t>(compared));
    SCOPED_TRACE(random.trace());
    BlockMasks masks;
    CellSet plain;
    for (int step = 0; step < 400; ++step, ++compared) {
      const Cell cell = center + random.cell(-20, 20);
      if (random.chance(0.5)) {
        const bool member = random.chance(0.4);
        masks.set(cell, member);
        member ? void(plain.insert(cell)) : void(plain.erase(cell));
      } else {
        const CellBox box{.min = cell, .max = cell + random.cell(1, 6)};
        masks.add(box);
        test::for_each_cell_in(box, [&](const Cell& inside) { plain.insert(inside); });
      }
      ASSERT_EQ(masks.size(), static_cast<std::int64_t>(plain.size()));
      const Cell low = center + random.cell(-40, 20);
      const CellBox asked{.min = low, .max = low + random.cell(1, 50)};
      CellSet visited;
      masks.for_each(asked, [&](const Cell& inside) {
        ASSERT_TRUE(asked.contains(inside) && visited.insert(inside).second);
      });
      std::size_t expected = 0;
      for (const Cell& member : plain) expected += asked.contains(member) ? 1 : 0;
      ASSERT_EQ(visited.size(), expected);
      ASSERT_EQ(masks.missing(asked), asked.extent().prod() - static_cast<std::int64_t>(expected));
      ASSERT_EQ(masks.contains(low), plain.contains(low));
    }
    CellSet all;
    masks.for_each_block([&](const Cell& origin, const CellMask& cells) {
      cells.for_each([&](BlockPosition position) { all.insert(origin + block_offset(position)); });
    });
    ASSERT_EQ(all, plain);
  }
  EXPECT_EQ(compared, 3 * 400);
}

}  // namespace
}  // namespace rmap
