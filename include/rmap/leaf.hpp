#pragma once

#include <cstdint>
#include <span>

#include <rmap/packed_block.hpp>

namespace rmap {

/// A cell and its value.
struct CellValue {
  Cell cell;
  Value value;

  friend bool operator==(const CellValue& a, const CellValue& b) {
    return a.cell == b.cell && a.value == b.value;
  }
};

/// Cells of a block, and a value for each in the order of positions.
struct BlockValues {
  Cell origin;  ///< lowest cell of the block, a multiple of 8 on each axis
  CellMask cells;
  std::span<const Value> values;
};

/// A leaf branch of a grid's R-tree as it lies in memory: the existing cells of
/// a block (edge 8), or one cell (edge 1). Valid until the grid changes.
struct Leaf {
  /// Lowest cell of the leaf's box, a multiple of `edge`.
  Cell origin;
  std::int32_t edge;
  /// A block's cells as in packed_block; the value of one cell.
  const Value* content;

  CellBox box() const { return {.min = origin, .max = origin + Cell::Constant(edge)}; }
  /// Which cells exist.
  CellMask cells() const { return edge == 1 ? CellMask::single(0) : packed_block::cells(content); }
  /// Those of a block that lie in a box.
  CellMask cells(const CellsBetween& box) const { return packed_block::cells(content, box); }
  /// The values of all in the order of positions.
  const Value* values() const { return edge == 1 ? content : packed_block::values(content); }
  /// The value of a cell that lies in the leaf, null where it does not exist.
  const Value* find(const Cell& cell) const {
    return edge == 1 ? content : packed_block::find(content, block_position(cell));
  }

  /// use(cell, value) for each existing cell, in Morton order.
  template <class Use>
  void for_each(Use&& use) const {
    if (edge == 1) {
      use(origin, *content);
      return;
    }
    packed_block::for_each(content, [&](BlockPosition position, Value value) {
      use(Cell(origin + block_offset(position)), value);
    });
  }
};

}  // namespace rmap
