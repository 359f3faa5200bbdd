// One hash a scene, whatever the compiler, its flags, the vector instructions, the layout,
// the traversal or the threads.
// A change here is a change of the definition of a map.
#include "support/grids.hpp"
#include "support/simd_targets.hpp"

#include <gtest/gtest.h>

#include <rmap/simulation.hpp>

namespace rmap {
namespace {

struct Golden {
  const char* scene;
  int scans;
  std::uint64_t hash;
};

void PrintTo(const Golden& golden, std::ostream* out) { *out << golden.scene; }

class GoldenMaps : public testing::TestWithParam<Golden> {};

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenMaps,
                         testing::Values(Golden{"room", 4, 6839451523328740863U},
                                         Golden{"stairs", 4, 15631339054859786572U},
                                         Golden{"street", 3, 15227087611214318337U},
                                         Golden{"moving", 6, 3226270312738833926U}),
                         [](const auto& golden) { return std::string(golden.param.scene); });

TEST_P(GoldenMaps, HaveTheirHashHoweverTheyAreMade) {
  const Simulation simulation =
      make_simulation(GetParam().scene, {.scans = GetParam().scans, .noise = 0.01, .seed = 7});
  const std::vector<Scan> scans(simulation.begin(), simulation.end());
  const auto expect_hash = [&](const Options& options) {
    Grid grid(options);
    for (const Scan& scan : scans) grid.insert(scan);
    EXPECT_EQ(test::map_hash(grid), GetParam().hash);
  };
  Options options{.resolution = 0.2, .max_range = 20};
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    options.layout = layout;
    options.traversal = Traversal::forward;
    expect_hash(options);
    options.traversal = Traversal::inverse;
    test::for_each_simd_target([&](const char* target) {
      SCOPED_TRACE(target);
      expect_hash(options);
    });
    for (const int threads : {2, 3, 8}) {
      SCOPED_TRACE(threads);
      options.threads = threads;
      expect_hash(options);
    }
    options.threads = 1;
  }
}

}  // namespace
}  // namespace rmap
