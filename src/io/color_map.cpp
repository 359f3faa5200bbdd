#include "io/color_map.hpp"

#include <algorithm>
#include <cmath>

namespace rmap {

namespace {

// Of equal distance on the scale; between them lines do.
constexpr std::array<Color, 16> kViridis = {{{0x44, 0x01, 0x54},
                                             {0x48, 0x1a, 0x6c},
                                             {0x47, 0x2f, 0x7d},
                                             {0x41, 0x44, 0x87},
                                             {0x39, 0x56, 0x8c},
                                             {0x31, 0x68, 0x8e},
                                             {0x2a, 0x78, 0x8e},
                                             {0x23, 0x88, 0x8e},
                                             {0x1f, 0x98, 0x8b},
                                             {0x22, 0xa8, 0x84},
                                             {0x35, 0xb7, 0x79},
                                             {0x54, 0xc5, 0x68},
                                             {0x7a, 0xd1, 0x51},
                                             {0xa5, 0xdb, 0x36},
                                             {0xd2, 0xe2, 0x1b},
                                             {0xfd, 0xe7, 0x25}}};

}  // namespace

Color viridis(double share) {
  const double place = std::clamp(share, 0.0, 1.0) * (kViridis.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), kViridis.size() - 2);
  const double weight = place - static_cast<double>(below);
  Color color;
  for (std::size_t i = 0; i < color.size(); ++i) {
    const double low = kViridis[below][i];
    const double high = kViridis[below + 1][i];
    color[i] = static_cast<std::uint8_t>(std::lround(low + weight * (high - low)));
  }
  return color;
}

void HeightScale::add(double height) {
  low_ = empty_ ? height : std::min(low_, height);
  high_ = empty_ ? height : std::max(high_, height);
  empty_ = false;
}

double HeightScale::share(double height) const {
  return high_ > low_ ? (height - low_) / (high_ - low_) : 0;
}

}  // namespace rmap
