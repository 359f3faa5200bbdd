#pragma once

#include "grid/leaf_store.hpp"

#include <utility>
#include <vector>

namespace rmap {

/// Marked cells, by leaf: those that a scan hit, or crossed. Valid while no
/// leaf comes or goes.
class LeafMarks {
 public:
  explicit LeafMarks(LeafId id_limit) : index_(id_limit, 0) {}

  /// The marks `marked`, each leaf once.
  LeafMarks(LeafId id_limit, std::vector<MarkedLeaf> marked)
      : index_(id_limit, 0), marked_(std::move(marked)) {
    for (std::size_t i = 0; i < marked_.size(); ++i) {
      index_[marked_[i].id] = static_cast<std::uint32_t>(i + 1);
    }
  }

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
    for (const MarkedLeaf& marked : other.marked_) at(marked.id, marked.origin) |= marked.cells;
  }

  /// The leaves with marks, in the order in which they were first asked for.
  const std::vector<MarkedLeaf>& marked() const& { return marked_; }
  std::vector<MarkedLeaf> marked() && { return std::move(marked_); }

 private:
  std::vector<std::uint32_t> index_;  ///< 1 + place in marked_, by leaf
  std::vector<MarkedLeaf> marked_;
};

}  // namespace rmap
