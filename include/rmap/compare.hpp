#pragma once

#include <span>

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

/// Where the points of a cloud lie in a map, and which cells have none.
struct CloudComparison {
  std::uint64_t points = 0;
  std::uint64_t not_finite = 0;     ///< points that lie nowhere
  std::uint64_t beyond_limits = 0;  ///< points beyond what a map can hold
  std::uint64_t in_occupied = 0;    ///< points in cells of this state
  std::uint64_t in_free = 0;
  std::uint64_t in_assumed_free = 0;
  std::uint64_t cells_without_point = 0;  ///< existing cells, occupied ones too
  std::uint64_t occupied_without_point = 0;
};

/// `points`: metres, in the map's frame. Cost: sorting them.
CloudComparison compare_with_cloud(const Grid& grid, std::span<const Vector3f> points);

}  // namespace rmap
