#include "approximation/cover_tiles.hpp"

#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

// Small scenes in many tiles.
constexpr Tiling kSmallTiles{.edge = 16, .halo = 4, .whole = 0};

std::vector<test::NamedCells> scenes_of_tiles(Random& random) {
  std::vector<test::NamedCells> scenes = test::small_scenes(random);
  const Cell at(-37, 5, 100);
  scenes.push_back({"larger_fill", test::moved(test::random_fill(random, 40, 0.3), at)});
  scenes.push_back({"larger_planes", test::moved(test::thin_planes(40), at)});
  scenes.push_back({"larger_ball", test::ball(20)});
  scenes.push_back({"larger_room", test::noisy_room(random, 8000, 0.1)});
  scenes.push_back({"wide", test::scattered(random, 300, 200)});
  return scenes;
}

TEST(CoverTiles, KeepTheirLimitsWithAnyNumberOfThreads) {
  int compared = 0;
  Random random(1);
  SCOPED_TRACE(random.trace());
  for (const auto& [name, cells] : scenes_of_tiles(random)) {
    SCOPED_TRACE(name);
    const CellBlocks blocks(test::counted(cells));
    for (const auto& [outer, inner] : {std::pair{0, 0}, {1, 0}, {2, 1}, {0, 1}}) {
      const CoverLimits limits{.outer = outer, .inner = inner};
      const auto boxes = cover_by_tiles(blocks, limits, 1, kSmallTiles);
      ASSERT_EQ(test::violation(test::set_of(cells), boxes, outer, inner), "");
      for (const int threads : {2, 3, 8}) {
        ASSERT_EQ(cover_by_tiles(blocks, limits, threads, kSmallTiles), boxes);
      }
      const auto whole = cover_by_tiles(blocks, limits, 1);
      ASSERT_EQ(test::violation(test::set_of(cells), whole, outer, inner), "");
      ASSERT_EQ(cover_by_tiles(blocks, limits, 3), whole);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 20 * 4);
}

TEST(CoverTiles, AreAnchoredAtTheCells) {
  Random random(2);
  SCOPED_TRACE(random.trace());
  int compared = 0;
  for (const auto& [name, cells] : scenes_of_tiles(random)) {
    if (name.ends_with("indices")) continue;  // no room to move
    SCOPED_TRACE(name);
    const Cell by = random.cell(-100000, 100000);
    const CellBlocks here(test::counted(cells));
    const CellBlocks there(test::counted(test::moved(cells, by)));
    auto boxes = cover_by_tiles(here, {.outer = 1}, 1, kSmallTiles);
    for (CellBox& box : boxes) box = {.min = box.min + by, .max = box.max + by};
    ASSERT_EQ(cover_by_tiles(there, {.outer = 1}, 1, kSmallTiles), boxes);
    ++compared;
  }
  EXPECT_EQ(compared, 18);
}

TEST(CoverTiles, CutABoxIntoFewerThanTiles) {
  const CellBox box{.min = {-30, -30, -30}, .max = {30, 30, -20}};
  const CellBlocks blocks(test::counted(test::solid_box(box)));
  EXPECT_EQ(cover_by_tiles(blocks, {}, 1), std::vector{box});
  const auto tiled = cover_by_tiles(blocks, {}, 1, kSmallTiles);
  EXPECT_LE(tiled.size(), 16u);
  EXPECT_TRUE(cover_by_tiles(CellBlocks(), {}, 2).empty());
}

}  // namespace
}  // namespace rmap
