#pragma once

namespace rmap {

/// How an overfull node of an R-tree becomes two [Guttman 1984].
enum class Split {
  quadratic,  ///< seeds are the pair that wastes most: better nodes [RMAP 2.1], cost M^2
  linear,     ///< seeds are the pair farthest apart on one axis: cost M
};

/// The order in which items are packed into full nodes.
enum class Packing {
  sort_tile_recursive,  ///< slabs along x, tiles along y, runs along z, on every level
  hilbert,              ///< along the Hilbert curve through the centres of the boxes
};

/// Order (n, M) of an R-tree [RMAP 2] and how it is kept.
struct RTreeOptions {
  /// M, the largest number of branches of a node: 4 to 64. A larger M takes less
  /// memory, but its MBRCs overlap more [RMAP 2.1].
  int max_branches = 16;
  /// n, the smallest number of branches of a node but the root: 1 to M/2. 0 means M/2.
  int min_branches = 0;
  Split split = Split::quadratic;
  /// Edge in cells of the cubes that the tree holds, at most 2^30: every item is such a
  /// cube and only its lower corner is stored. 0: items are boxes of any shape.
  int leaf_edge = 0;
};

}  // namespace rmap
