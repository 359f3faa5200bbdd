#pragma once

#include "grid/cell_places.hpp"

#include <optional>
#include <vector>

#include <rmap/leaf.hpp>

namespace rmap {

/// A set of cells, gathered by blocks of 8 x 8 x 8: the end cells of a scan.
class BlockMarks {
  auto origin_at() const {
    return [this](std::uint32_t place) -> const Cell& { return blocks_[place].origin; };
  }

 public:
  struct Block {
    Cell origin;
    CellMask cells;
  };

  /// Hash of a block's lowest cell.
  static std::uint32_t hash_of(const Cell& origin) { return CellPlaces::hash_of(origin); }

  /// Returns the place in blocks() of the cell's block.
  std::uint32_t add(const Cell& cell) {
    const Cell origin = block_origin(cell);
    return add(origin, hash_of(origin), block_position(cell));
  }
  std::uint32_t add(const Cell& origin, std::uint32_t hash, BlockPosition position) {
    const std::uint32_t place = place_of(origin, hash);
    blocks_[place].cells.set(position);
    return place;
  }
  void add(const BlockMarks& other) {
    for (const Block& block : other.blocks_) {
      blocks_[place_of(block.origin, hash_of(block.origin))].cells |= block.cells;
    }
  }

  /// Place in blocks() of a block, if it has marks.
  std::optional<std::uint32_t> find(const Cell& origin) const {
    return places_.find(origin, origin_at());
  }
  /// The blocks with marks, in the order in which they got the first.
  const std::vector<Block>& blocks() const { return blocks_; }
  /// Number of cells.
  std::uint64_t count() const {
    std::uint64_t count = 0;
    for (const Block& block : blocks_) count += block.cells.count();
    return count;
  }

 private:
  std::uint32_t place_of(const Cell& origin, std::uint32_t hash) {
    const std::uint32_t place = places_.add(origin, hash, origin_at());
    if (place == blocks_.size()) blocks_.push_back({origin, {}});
    return place;
  }

  CellPlaces places_;
  std::vector<Block> blocks_;
};

}  // namespace rmap
