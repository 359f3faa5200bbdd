#pragma once

#include "grid/cell_places.hpp"

#include <vector>

#include <rmap/leaf.hpp>

namespace rmap {

/// A set of cells, gathered by blocks of 8 x 8 x 8: the end cells of a scan.
class BlockMarks {
 public:
  struct Block {
    Cell origin;
    CellMask cells;
  };

  void add(const Cell& cell) { at(block_origin(cell)).set(block_position(cell)); }
  void add(const BlockMarks& other) {
    for (const Block& block : other.blocks_) at(block.origin) |= block.cells;
  }

  /// Place in blocks() of a block that has marks.
  std::size_t place_of(const Cell& origin) const { return places_.at(number_of(origin)); }
  /// The blocks with marks, in the order in which they got the first.
  const std::vector<Block>& blocks() const { return blocks_; }

 private:
  // Blocks counted, so that the low bits tell them apart.
  static Cell number_of(const Cell& origin) {
    return origin.unaryExpr([](std::int32_t index) { return index / kBlockEdge; });
  }
  CellMask& at(const Cell& origin) {
    const std::uint32_t place = places_.add(number_of(origin));
    if (place == blocks_.size()) blocks_.push_back({origin, {}});
    return blocks_[place].cells;
  }

  CellPlaces places_;
  std::vector<Block> blocks_;
};

}  // namespace rmap
