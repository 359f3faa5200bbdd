#pragma once

#include <cstdint>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/lattice.hpp>
#include <rmap/pose.hpp>

namespace rmap {

/// What counts when cuboids are ranked, and what `sigma` is a share of.
enum class CuboidWeight {
  points,  ///< the points of a cell: dense, near surfaces first
  cells,   ///< each occupied cell the same
};

/// A rectangular cuboid (RC) of whole cells.
struct Cuboid {
  CellBox cells;
  /// Points in the cells of the cuboid, each cell counted by every cuboid that holds it.
  std::uint64_t points = 0;

  /// Points per cell of the cuboid, empty ones too [RMAP 2.3].
  double density() const { return static_cast<double>(points) / cells.volume(); }
  friend bool operator==(const Cuboid&, const Cuboid&) = default;
};

/// Cuboids in the order of what they add, the one that covers most first: each prefix is the best
/// picture of its length.
struct CuboidList {
  /// Edge of a cell, metres.
  double resolution = 0.1;
  /// From the input's frame to that of the cells: cuboids lie along its axes.
  Pose frame = Pose::Identity();
  std::vector<Cuboid> cuboids = {};
};

}  // namespace rmap
