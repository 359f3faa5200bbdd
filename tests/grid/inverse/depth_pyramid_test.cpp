#include "grid/inverse/depth_pyramid.hpp"

#include "support/random.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

TEST(DepthPyramid, ReachesAtLeastAsDeepAsTheBinsOfARectangle) {
  test::Random random(74);
  SCOPED_TRACE(random.trace());
  constexpr int kBins = 32;
  int reached = 0;
  int not_reached = 0;
  for (int round = 0; round < 20; ++round) {
    DepthPyramid pyramid(kBins);
    std::vector<std::vector<float>> rows(std::size_t{cube_map::kFaces} * kBins);
    for (std::size_t row = 0; row < rows.size(); ++row) {
      if (random.chance(0.7)) continue;
      for (int u = 0; u < kBins; ++u) {
        rows[row].push_back(random.chance(0.5) ? 0 : static_cast<float>(random.real(1, 100)));
      }
      pyramid.add_row(row, rows[row].data());
    }
    pyramid.finish();
    for (int i = 0; i < 500; ++i) {
      const int face = random.integer(0, cube_map::kFaces - 1);
      const int u = random.integer(0, kBins - 1);
      const int v = random.integer(0, kBins - 1);
      const cube_map::Bins us{u, random.integer(u, i % 2 == 0 ? u : kBins - 1)};
      const cube_map::Bins vs{v, random.integer(v, i % 3 == 0 ? v : kBins - 1)};
      float deepest = 0;
      for (int row = vs.first; row <= vs.last; ++row) {
        const auto& depths =
            rows[static_cast<std::size_t>(face) * kBins + static_cast<std::size_t>(row)];
        if (depths.empty()) continue;
        for (int bin = us.first; bin <= us.last; ++bin) {
          deepest = std::max(deepest, depths[static_cast<std::size_t>(bin)]);
        }
      }
      const auto asked = static_cast<float>(random.real(0, 100));
      const bool answer = pyramid.reaches(face, us, vs, asked);
      EXPECT_TRUE(answer || deepest <= asked);
      ++(answer ? reached : not_reached);
    }
  }
  EXPECT_GT(reached, 100);
  EXPECT_GT(not_reached, 100);
}

}  // namespace
}  // namespace rmap
