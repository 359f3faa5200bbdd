#pragma once

#include <rmap/grid.hpp>

namespace rmap {

/// How two maps of one resolution differ, in cells.
struct MapDifference {
  std::uint64_t both = 0;    ///< cells that exist in both
  std::uint64_t only_a = 0;  ///< cells that exist in the first only
  std::uint64_t only_b = 0;
  std::uint64_t occupied_both = 0;
  std::uint64_t occupied_only_a = 0;  ///< occupied in the first and not in the second (or absent)
  std::uint64_t occupied_only_b = 0;
  std::uint64_t state_differs = 0;  ///< exist in both, occupied in one only
  std::uint64_t value_differs = 0;  ///< exist in both, with another value
  double max_difference = 0;        ///< largest difference of probability in a cell of both

  bool same_cells() const { return only_a == 0 && only_b == 0 && value_differs == 0; }
};

/// Throws Error(input) when the resolutions differ.
MapDifference compare(const Grid& a, const Grid& b);

}  // namespace rmap
