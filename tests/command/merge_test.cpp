#include "command/command.hpp"
#include "support/random.hpp"

#include <gmock/gmock.h>

#include <rmap/map_file.hpp>

namespace rmap::test {

namespace {

using Merge = CommandTest;

TEST_F(Merge, AddsMapsAsTheLibraryDoes) {
  Random random(74);
  SCOPED_TRACE(random.trace());
  std::vector<Grid> grids;
  for (const char* name : {"a.rmap", "b.rmap", "c.rmap"}) {
    Grid& grid = grids.emplace_back(Options{.resolution = 0.2});
    for (int i = 0; i < 200; ++i) grid.set(random.cell(-5, 5), random.real(0.2, 0.9));
    save(grid, folder() / name);
  }
  const auto answer = rmap_json({"merge", "a.rmap", "b.rmap", "c.rmap", "-o", "sum.rmap"});
  grids[0].merge(grids[1]);
  grids[0].merge(grids[2]);
  EXPECT_TRUE(same_map(grids[0], load(folder() / "sum.rmap")));
  EXPECT_EQ(answer["cells"], grids[0].cell_count());
  EXPECT_EQ(answer["maps"].size(), 3u);
}

TEST_F(Merge, RefusesMapsThatDoNotFit) {
  save(Grid({.resolution = 0.2}), folder() / "a.rmap");
  save(Grid({.resolution = 0.1}), folder() / "b.rmap");
  EXPECT_THAT(
      rmap_refused(1, {"merge", "a.rmap", "b.rmap", "-o", "sum.rmap"}),
      testing::AllOf(testing::HasSubstr("a.rmap and b.rmap"), testing::HasSubstr("resolution")));
  EXPECT_THAT(rmap_refused(2, {"merge", "a.rmap", "-o", "sum.rmap"}),
              testing::HasSubstr("two or more"));
  EXPECT_FALSE(std::filesystem::exists(folder() / "sum.rmap"));
}

// The output may be one of the inputs: it is replaced once it is complete.
TEST_F(Merge, MayReplaceAnInput) {
  Grid a({.resolution = 0.2});
  a.set({1, 2, 3}, 0.8);
  save(a, folder() / "a.rmap");
  rmap_done({"merge", "a.rmap", "a.rmap", "-o", "a.rmap"});
  a.merge(Grid(a));
  EXPECT_TRUE(same_map(a, load(folder() / "a.rmap")));
}

}  // namespace

}  // namespace rmap::test
