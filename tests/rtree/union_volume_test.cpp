#include "rtree/union_volume.hpp"

#include "rtree/boxes.hpp"

#include <unordered_set>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

TEST(UnionVolume, EqualsACountOfCells) {
  int compared = 0;
  for (int round = 0; round < 100; ++round, ++compared) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(random.trace());
    std::vector<CellBox> boxes;
    std::unordered_set<Cell, CellHash> cells;
    for (int i = random.integer(0, 12); i > 0; --i) {
      boxes.push_back(random.box(-6, 6, 5));
      const CellBox& box = boxes.back();
      for (int x = box.min.x(); x < box.max.x(); ++x) {
        for (int y = box.min.y(); y < box.max.y(); ++y) {
          for (int z = box.min.z(); z < box.max.z(); ++z) cells.insert({x, y, z});
        }
      }
    }
    ASSERT_EQ(static_cast<std::size_t>(cells_in_union(boxes)), cells.size());
  }
  EXPECT_EQ(compared, 100);
}

TEST(UnionVolume, IsExactAcrossAllLimits) {
  const CellBox all = all_cells();
  EXPECT_TRUE(cells_in(all) == CellCount{1} << 93);
  EXPECT_TRUE(cells_in_union(std::vector<CellBox>{all, box_of({3, 4, 5})}) == CellCount{1} << 93);
  CellBox lower = all;
  lower.max.x() = 1;
  CellBox upper = all;
  upper.min.x() = 0;
  EXPECT_TRUE(cells_in_union(std::vector<CellBox>{lower, upper}) == CellCount{1} << 93);
  EXPECT_TRUE(cells_in(CellBox{}) == 0);
  EXPECT_TRUE(cells_in_union({}) == 0);
}

}  // namespace
}  // namespace rmap
