#include "support/plain_crossing.hpp"

#include <cmath>

namespace rmap::test {

bool plain_crosses(const PlainBeam& beam, const Cell& cell) {
  double enter = 0;
  double leave = 1;
  bool moves = false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double direction = beam.end[i] - beam.origin[i];
    if (std::fabs(direction) < std::ldexp(1.0, -40)) {
      if (static_cast<double>(cell[axis]) != std::floor(beam.origin[i])) return false;
      continue;
    }
    moves = true;
    const double low = (static_cast<double>(cell[axis]) - beam.origin[i]) / direction;
    const double high = (static_cast<double>(cell[axis]) + 1 - beam.origin[i]) / direction;
    enter = std::fmax(enter, std::fmin(low, high));
    leave = std::fmin(leave, std::fmax(low, high));
  }
  return (moves || beam.cut) && enter < leave;
}

std::vector<Cell> plain_crossed_cells(const PlainBeam& beam, const CellBox& box) {
  std::vector<Cell> crossed;
  for (std::int32_t z = box.min.z(); z < box.max.z(); ++z) {
    for (std::int32_t y = box.min.y(); y < box.max.y(); ++y) {
      for (std::int32_t x = box.min.x(); x < box.max.x(); ++x) {
        if (plain_crosses(beam, {x, y, z})) crossed.emplace_back(x, y, z);
      }
    }
  }
  return crossed;
}

}  // namespace rmap::test
