#pragma once

#include <cstddef>
#include <vector>

namespace rmap {

/// The shape of one level of an R-tree. Volumes are in cells.
struct RTreeLevelStatistics {
  /// Counted from the leaves, which are level 0.
  int level = 0;
  std::size_t nodes = 0;
  std::size_t branches = 0;
  /// Share of the branches that the nodes have room for: branches / (nodes * M).
  double fill = 0;
  /// Volume of the MBRCs of the nodes, summed.
  double volume = 0;
  /// Volume that two branches of one node share, summed over all such pairs. Overlap is
  /// what sends a search into several nodes [RMAP 2.1].
  double overlap_volume = 0;
  /// Volume of the nodes' MBRCs that no branch of the node covers, summed; exact for each node.
  double dead_space = 0;
};

/// The shape of an R-tree: what M trades between memory and overlap [RMAP 3.1].
struct RTreeStatistics {
  /// From the leaves, levels[0], to the root; none when the tree is empty.
  std::vector<RTreeLevelStatistics> levels;
  int height = 0;
  std::size_t items = 0;
  std::size_t nodes = 0;
  std::size_t bytes_in_use = 0;
};

}  // namespace rmap
