#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include <rmap/value.hpp>

namespace rmap {

/// Position of a cell in a block of 8 x 8 x 8: along the Morton curve, x the
/// fastest axis, so that 8 positions are a 2 x 2 x 2 and 64 a 4 x 4 x 4 sub-block.
using BlockPosition = std::uint32_t;

inline constexpr std::int32_t kBlockEdge = 8;
inline constexpr std::uint32_t kBlockCells = 512;

/// A set of positions in a block. A leaf branch that is a single cell uses position 0 only.
class CellMask {
 public:
  bool test(BlockPosition position) const { return ((words_[position / 64] >> (position % 64)) & 1) != 0; }
  constexpr void set(BlockPosition position) { words_[position / 64] |= bit(position); }
  void reset(BlockPosition position) { words_[position / 64] &= ~bit(position); }
  bool none() const { return *this == CellMask{}; }
  std::uint32_t count() const;
  /// How many positions of the set lie before `position`.
  std::uint32_t rank(BlockPosition position) const;

  const std::array<std::uint64_t, 8>& words() const { return words_; }
  std::array<std::uint64_t, 8>& words() { return words_; }

  CellMask& operator|=(const CellMask& other);
  CellMask& operator&=(const CellMask& other);
  /// The positions of this set that are not in `other`.
  CellMask without(const CellMask& other) const;
  friend CellMask operator&(CellMask a, const CellMask& b) { return a &= b; }
  friend bool operator==(const CellMask&, const CellMask&) = default;

  /// use(position) for each position of the set, ascending.
  template <class Use>
  void for_each(Use&& use) const {
    for (std::uint32_t word = 0; word < words_.size(); ++word) {
      for (std::uint64_t left = words_[word]; left != 0; left &= left - 1) {
        use(word * 64 + static_cast<BlockPosition>(std::countr_zero(left)));
      }
    }
  }

 private:
  static constexpr std::uint64_t bit(BlockPosition position) { return std::uint64_t{1} << (position % 64); }

  std::array<std::uint64_t, 8> words_{};
};

/// Position of `cell` in the block that holds it.
BlockPosition block_position(const Cell& cell);
/// Offset of a position from the block's lowest cell: 0 to 7 on each axis.
Cell block_offset(BlockPosition position);
/// Lowest cell of the block that holds `cell`.
inline Cell block_origin(const Cell& cell) {
  return cell.unaryExpr([](std::int32_t index) { return index & ~(kBlockEdge - 1); });
}

/// A cell and its value.
struct CellValue {
  Cell cell;
  Value value;

  friend bool operator==(const CellValue& a, const CellValue& b) {
    return a.cell == b.cell && a.value == b.value;
  }
};

/// A leaf branch of a grid's R-tree as it lies in memory: the existing cells of
/// a block (edge 8), or one cell (edge 1). Valid until the grid changes.
struct Leaf {
  /// Lowest cell of the leaf's box, a multiple of `edge`.
  Cell origin;
  std::int32_t edge;
  /// Which cells exist.
  const CellMask* cells;
  /// Their values in the order of positions.
  const Value* values;

  CellBox box() const { return {.min = origin, .max = origin + Cell::Constant(edge)}; }

  /// use(cell, value) for each existing cell, in Morton order.
  template <class Use>
  void for_each(Use&& use) const {
    const Value* value = values;
    cells->for_each([&](BlockPosition position) {
      use(Cell(origin + block_offset(position)), *value);
      ++value;
    });
  }
};

}  // namespace rmap
