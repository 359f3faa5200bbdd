#pragma once

#include "grid/block_marks.hpp"
#include "grid/leaf_store.hpp"

#include <span>
#include <vector>

namespace rmap {

/// The end cells of a scan by the leaves that hold them: which ones a walk over the leaves of a
/// map met, and which are left.
class EndLeaves {
 public:
  /// A leaf that has end cells and was met.
  struct Met {
    std::uint32_t block;     ///< place among the blocks with end cells
    BlockPosition position;  ///< of the leaf's lowest cell in the block
  };

  /// Keeps references to both.
  EndLeaves(const LeafStore& store, const BlockMarks& ends) : store_(store), ends_(ends) {}

  /// The end cells in a leaf, null when there are none, and where they stand.
  const CellMask* find(const Leaf& leaf, Met& met) const {
    const auto block = ends_.find(block_origin(leaf.origin));
    if (!block) return nullptr;
    met = {*block, block_position(leaf.origin)};
    if (leaf.edge == kBlockEdge) return &cells(*block);
    static constexpr CellMask kOneCell = CellMask::single(0);
    return cells(*block).test(met.position) ? &kOneCell : nullptr;
  }
  /// All end cells in a block.
  const CellMask& cells(std::uint32_t block) const { return ends_.blocks()[block].cells; }
  const Cell& origin(std::uint32_t block) const { return ends_.blocks()[block].origin; }

  /// Those that are left: met leaves are to be taken out.
  class Rest {
   public:
    explicit Rest(const EndLeaves& all) : all_(all) {
      left_.reserve(all.ends_.blocks().size());
      for (const BlockMarks::Block& block : all.ends_.blocks()) left_.push_back(block.cells);
    }
    void take(std::span<const Met> leaves) {
      for (const Met& met : leaves) {
        if (all_.store_.edge() == kBlockEdge) {
          left_[met.block] = {};
        } else {
          left_[met.block].reset(met.position);
        }
      }
    }
    /// The blocks that have some left, with those.
    std::vector<BlockMarks::Block> blocks() const {
      std::vector<BlockMarks::Block> blocks;
      for (std::uint32_t i = 0; i < left_.size(); ++i) {
        if (!left_[i].none()) blocks.push_back({all_.origin(i), left_[i]});
      }
      return blocks;
    }

   private:
    const EndLeaves& all_;
    std::vector<CellMask> left_;
  };

 private:
  const LeafStore& store_;
  const BlockMarks& ends_;
};

}  // namespace rmap
