#pragma once

#include "io/octomap/leaves.hpp"

#include <rmap/grid.hpp>

namespace rmap::octomap {

/// Gives a grid the cells of leaves that come in Morton order, by blocks and many at a time.
class BlockGatherer {
 public:
  explicit BlockGatherer(Grid& grid) : grid_(grid) {}

  /// All cells of a leaf, with one value.
  void add(const Leaf& leaf, Value value);
  /// To be called behind the last leaf.
  void flush();

 private:
  void add_block(const Cell& origin);

  Grid& grid_;
  std::vector<Cell> origins_;
  std::vector<CellMask> masks_;
  std::vector<Value> values_;  ///< of all blocks, one after the other
};

}  // namespace rmap::octomap
