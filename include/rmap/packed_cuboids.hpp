#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <rmap/cuboids.hpp>

namespace rmap {

/// A cuboid in 8 bytes: offsets of its lowest cell in a chunk of 256 cells each way, and its edges,
/// up to 256 cells. 2 bytes are spare.
struct PackedCuboid {
  std::uint8_t offset[3] = {};
  std::uint8_t edge_less_one[3] = {};
  std::uint16_t spare = 0;

  friend bool operator==(const PackedCuboid&, const PackedCuboid&) = default;
};
static_assert(sizeof(PackedCuboid) == 8);

/// The cuboids whose lowest cells lie in one chunk.
struct CuboidChunk {
  Cell origin;  ///< lowest cell of the chunk, a multiple of 256
  std::vector<PackedCuboid> cuboids;
};

/// Boxes as chunks, in the order in which chunks are first met, each in the order of the list;
/// boxes longer than 256 cells are cut. Points are not kept. Throws Error(limit) for a box that is
/// empty or beyond the limits, and beyond 2^28 parts.
std::vector<CuboidChunk> pack(std::span<const Cuboid> cuboids);
/// The boxes of chunks, with 0 points.
std::vector<Cuboid> unpack(std::span<const CuboidChunk> chunks);

}  // namespace rmap
