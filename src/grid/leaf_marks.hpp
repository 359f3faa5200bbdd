#pragma once

#include <vector>

#include "grid/leaf_store.hpp"

namespace rmap {

/// Marked cells, by leaf: those that a scan hit, or crossed. Valid while no
/// leaf comes or goes.
class LeafMarks {
 public:
  explicit LeafMarks(LeafId id_limit) : index_(id_limit, 0) {}

  /// The marks of a leaf, to be added to.
  CellMask& at(LeafId id, const Cell& origin) {
    if (index_[id] == 0) {
      marked_.push_back({id, origin, {}});
      index_[id] = static_cast<std::uint32_t>(marked_.size());
    }
    return marked_[index_[id] - 1].cells;
  }

  /// The marks of a leaf, null when it has none.
  const CellMask* find(LeafId id) const {
    return index_[id] == 0 ? nullptr : &marked_[index_[id] - 1].cells;
  }

  void add(const LeafMarks& other) {
    for (const Marked& marked : other.marked_) at(marked.id, marked.origin) |= marked.cells;
  }

  struct Marked {
    LeafId id;
    Cell origin;
    CellMask cells;
  };
  /// The leaves with marks, in the order in which they were first asked for.
  const std::vector<Marked>& marked() const { return marked_; }

 private:
  std::vector<std::uint32_t> index_;  ///< 1 + place in marked_, by leaf
  std::vector<Marked> marked_;
};

}  // namespace rmap
