#pragma once

#include <cstdint>
#include <span>

#include <rmap/counted_cells.hpp>
#include <rmap/cuboids.hpp>

namespace rmap {

/// How cuboids differ from the cells that they stand for. Distances are Chebyshev, in cells.
struct CuboidError {
  std::uint64_t cells = 0;   ///< occupied cells
  std::uint64_t points = 0;  ///< in them
  std::uint64_t cuboids = 0;
  std::uint64_t volume = 0;           ///< cells in the union of the cuboids
  std::uint64_t lost_cells = 0;       ///< occupied cells outside every cuboid
  std::uint64_t lost_points = 0;      ///< points in them
  std::uint64_t lost_beyond_one = 0;  ///< lost cells farther than one cell from every cuboid
  std::uint64_t false_cells = 0;      ///< empty cells in the union
  std::int32_t farthest_false = 0;    ///< of an empty cell in the union to the nearest occupied one
  std::int32_t farthest_lost = 0;     ///< of a lost cell to the nearest cuboid; 0 without cuboids

  /// Share of the union that is empty.
  double false_share() const {
    return volume == 0 ? 0 : static_cast<double>(false_cells) / static_cast<double>(volume);
  }
};

/// Compares cuboids with the cells, in any order, that they are an approximation of. Cost: by
/// cells and by the volume of the union; memory: by blocks of 8 x 8 x 8 cells in either.
/// Throws Error(limit) when the union has 2^31 cells or more.
CuboidError cuboid_error(std::span<const CountedCell> cells, std::span<const Cuboid> cuboids);

/// Bytes that the same cells, or their cuboids, take in other forms.
struct CuboidBytes {
  std::uint64_t plain = 0;       ///< 24 a cuboid: six integers [RMAP 3.3]
  std::uint64_t packed = 0;      ///< 8 a cuboid, long ones cut: rmap/packed_cuboids.hpp
  std::uint64_t raw_points = 0;  ///< 12 a point
  std::uint64_t voxel_keys = 0;  ///< 12 a cell
  std::uint64_t octomap = 0;     ///< an OctoMap of the end points alone, by the paper's formula:
                                 ///< 16 a leaf and 80 an inner node [RMAP 3.2]
  std::uint64_t octomap_pruned = 0;  ///< the same with eight equal leaves joined to one
  std::uint64_t bit_blocks = 0;      ///< 72 for each block of 8 x 8 x 8 cells: a key and 512 bits
};

CuboidBytes cuboid_bytes(std::span<const CountedCell> cells, std::span<const Cuboid> cuboids);

}  // namespace rmap
