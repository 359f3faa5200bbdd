#pragma once

#include <array>
#include <cstdint>

namespace rmap {

/// A colour as screens take it: sRGB.
using Color = std::array<std::uint8_t, 3>;

/// viridis, of equal steps to the eye and legible to the colour-blind: from 0, dark violet, to 1,
/// yellow; what is beyond has the nearest colour.
Color viridis(double share);

/// Heights in metres as shares of the way from the lowest to the highest.
class HeightScale {
 public:
  void add(double height);
  double share(double height) const;

 private:
  double low_ = 0;
  double high_ = 0;
  bool empty_ = true;
};

}  // namespace rmap
