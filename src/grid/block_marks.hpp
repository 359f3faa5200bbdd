#pragma once

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

  BlockMarks();

  void add(const Cell& cell) { at(block_origin(cell)).set(block_position(cell)); }
  void add(const BlockMarks& other);

  /// Place in blocks() of a block that has marks.
  std::size_t place_of(const Cell& origin) const { return slots_[slot_of(origin)].place - 1; }
  /// The blocks with marks, in the order in which they got the first.
  const std::vector<Block>& blocks() const { return blocks_; }

 private:
  CellMask& at(const Cell& origin) {
    const std::uint32_t place = slots_[slot_of(origin)].place;
    return blocks_[place == 0 ? added(origin) : place - 1].cells;
  }
  std::size_t added(const Cell& origin);
  static std::size_t hash_of(const Cell& origin) {
    // Blocks start at multiples of 8: the low bits say nothing.
    const auto index = [&](int axis) { return static_cast<std::uint32_t>(origin[axis] >> 3); };
    const std::uint32_t hash =
        (index(0) * 0x9E3779B1U) ^ (index(1) * 0x85EBCA77U) ^ (index(2) * 0xC2B2AE3DU);
    return hash ^ (hash >> 15);
  }
  // The slot that holds `origin`, or the free one where it belongs.
  std::size_t slot_of(const Cell& origin) const {
    std::size_t slot = hash_of(origin) & (slots_.size() - 1);
    while (slots_[slot].place != 0 && slots_[slot].origin != origin) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }
  void grow();

  struct Slot {
    Cell origin;
    std::uint32_t place;  ///< 1 + place in blocks_, 0 when the slot is free
  };

  std::vector<Block> blocks_;
  std::vector<Slot> slots_;  ///< open addressing; a power of two
};

}  // namespace rmap
