#pragma once

#include "evaluation/json.hpp"
#include "evaluation/sequence.hpp"

#include <string>
#include <vector>

#include <rmap/rtree.hpp>

namespace rmap::evaluation {

/// One R-tree over the end cells of a sequence [RMAP 3.1].
struct RTreeRow {
  std::string sequence = {};
  double resolution = 0;
  std::string leaves = {};  ///< "cells", the paper's, or "blocks" of 8 x 8 x 8
  std::string built = {};   ///< "quadratic", "linear": one by one; "bulk": packed full
  int max_branches = 0;
  std::size_t items = 0;
  double insert_ns = 0;   ///< an item, in the order in which beams ended in them
  double extract_ns = 0;  ///< an item, going over all
  double find_ns = 0;     ///< an item, looked up by its box
  std::size_t bytes = 0;
  std::size_t nodes = 0;
  int height = 0;
  /// Volume that branches of one node share, of all pairs and levels, by the volume of the nodes.
  double overlap = 0;
  double overlap_of_node = 0;  ///< the same volume, in cells, by the number of nodes
  double dead_space = 0;       ///< volume of nodes that no branch covers, by the same
};

Json to_json(const RTreeRow& row);

struct RTreeExperimentOptions {
  double resolution = 0.1;
  int repetitions = 3;
};

/// M = 4, 8, 16, 32, 64; cells and blocks; both splits and bulk load.
std::vector<RTreeRow> rtree_experiment(const Sequence& sequence,
                                       const RTreeExperimentOptions& options);

}  // namespace rmap::evaluation
