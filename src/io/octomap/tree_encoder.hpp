#pragma once

#include "io/octomap/header.hpp"

#include <array>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap::octomap {

/// The nodes of a tree as a file of OctoMap has them: a parent before its children, which
/// decide what it says. So cells come from the last one of the Morton curve to the first, each
/// node is finished when all below it is, and the bytes are made backwards.
class TreeEncoder {
 public:
  /// `states_only`: the form of a `.bt`, where `log_odds` tells no more than the state.
  explicit TreeEncoder(bool states_only) : states_only_(states_only) {}

  /// A cell with indices from -kHalf to kHalf - 1 that comes before all cells so far in Morton
  /// order.
  void add(const Cell& cell, float log_odds);

  /// To be called behind the last cell: the bytes of all nodes in the order of the file.
  std::vector<std::byte> take_bytes();
  /// How many nodes there are, inner ones too. Complete with take_bytes().
  std::uint64_t nodes() const { return nodes_; }

 private:
  /// An inner node of whose children some are finished.
  struct Inner {
    std::uint32_t children = 0;  ///< a bit for each
    std::uint32_t states = 0;    ///< two bits for each, as in a `.bt`
    float highest = 0;           ///< of the children's log-odds
    bool equal_leaves = true;    ///< whether all so far are leaves of one value
  };

  void add_child(int level, std::uint32_t child, float log_odds, bool leaf);
  void finish(int level);
  void put_value(float log_odds, std::uint32_t children);

  bool states_only_;
  bool empty_ = true;
  std::uint64_t last_code_ = 0;          ///< place of the last cell on the Morton curve
  std::array<Inner, kDepth + 1> inner_;  ///< on the way to it, by level; 0 is not in use
  std::vector<std::byte> backwards_;
  std::uint64_t nodes_ = 0;
};

}  // namespace rmap::octomap
