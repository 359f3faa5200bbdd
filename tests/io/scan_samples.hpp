#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include <rmap/box.hpp>

namespace rmap::test {

/// A LAS file; `scale` and `offset` by axis.
struct Las {
  int minor = 2;
  int format = 0;
  std::uint16_t point_size = 20;
  std::vector<std::array<std::int32_t, 3>> points = {{{1, 2, 3}}, {{-400, 0, 1 << 30}}};
  Vector3d scale = {0.01, 0.5, 1e-3};
  Vector3d offset = {1000, -2000, 0};

  std::string bytes() const;
};

/// A vector as a scan graph of OctoMap holds it: its length, and as many doubles.
std::string graph_vector(std::initializer_list<double> values);

}  // namespace rmap::test
