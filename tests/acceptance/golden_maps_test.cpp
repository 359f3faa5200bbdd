// One hash a scene, whatever the compiler, its flags, the layout or the threads.
// A change here is a change of the definition of a map.
#include "support/grids.hpp"

#include <gtest/gtest.h>

#include <rmap/simulation.hpp>

namespace rmap {
namespace {

struct Golden {
  const char* scene;
  int scans;
  std::uint64_t hash;
};

class GoldenMaps : public testing::TestWithParam<Golden> {};

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenMaps,
                         testing::Values(Golden{"room", 4, 6839451523328740863u},
                                         Golden{"stairs", 4, 15631339054859786572u},
                                         Golden{"street", 3, 15227087611214318337u},
                                         Golden{"moving", 6, 3226270312738833926u}),
                         [](const auto& golden) { return std::string(golden.param.scene); });

TEST_P(GoldenMaps, HaveTheirHashInEveryLayoutAndWithAnyThreads) {
  const Simulation simulation =
      make_simulation(GetParam().scene, {.scans = GetParam().scans, .noise = 0.01, .seed = 7});
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    for (const int threads : {1, 2, 3}) {
      if (layout == Layout::cells && threads == 3) continue;
      Grid grid({.resolution = 0.2, .layout = layout, .max_range = 20, .threads = threads});
      for (const Scan& scan : simulation) grid.insert(scan);
      EXPECT_EQ(test::map_hash(grid), GetParam().hash) << threads << " threads";
    }
  }
}

}  // namespace
}  // namespace rmap
