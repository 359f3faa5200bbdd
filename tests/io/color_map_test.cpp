#include "io/color_map.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace rmap {
namespace {

TEST(ColorMap, is_viridis) {
  EXPECT_EQ(viridis(0), (Color{0x44, 0x01, 0x54}));
  EXPECT_EQ(viridis(1), (Color{0xfd, 0xe7, 0x25}));
  // Between the steps of the table, at the quarters: 3b528b, 21918c, 5ec962.
  const std::array<Color, 3> quarters = {
      {{0x3b, 0x52, 0x8b}, {0x21, 0x91, 0x8c}, {0x5e, 0xc9, 0x62}}};
  for (std::size_t i = 0; i < quarters.size(); ++i) {
    const Color color = viridis(0.25 * static_cast<double>(i + 1));
    for (std::size_t part = 0; part < 3; ++part)
      EXPECT_NEAR(color[part], quarters[i][part], 1) << i;
  }
}

TEST(ColorMap, holds_beyond_its_ends) {
  EXPECT_EQ(viridis(-3), viridis(0));
  EXPECT_EQ(viridis(7), viridis(1));
}

TEST(ColorMap, scales_heights) {
  HeightScale scale;
  EXPECT_EQ(scale.share(5), 0);
  scale.add(-2);
  EXPECT_EQ(scale.share(-2), 0);
  scale.add(6);
  scale.add(0);
  EXPECT_EQ(scale.share(-2), 0);
  EXPECT_EQ(scale.share(0), 0.25);
  EXPECT_EQ(scale.share(6), 1);
}

}  // namespace
}  // namespace rmap
