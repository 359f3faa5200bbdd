#pragma once

#include "approximation/block_walk.hpp"
#include "grid/cell_places.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <rmap/block.hpp>
#include <rmap/counted_cells.hpp>

namespace rmap {

/// A sparse set of cells by blocks, in which cells are found by place and have numbers. Memory: 80
/// bytes a block and 4 a cell.
class CellBlocks {
 public:
  struct Block {
    Cell origin;              ///< lowest cell
    std::uint32_t first = 0;  ///< number of the block's first cell
    CellMask cells;
  };

  CellBlocks() = default;
  /// Cells may repeat: the points of equal ones are added. Throws as check_cells.
  explicit CellBlocks(std::span<const CountedCell> cells);

  std::size_t size() const { return points_.size(); }
  std::span<const Block> blocks() const { return blocks_; }
  /// The smallest box that holds all cells; empty when there is none.
  const CellBox& bounds() const { return bounds_; }

  /// Points of a cell, by its number.
  std::uint32_t points(std::size_t number) const { return points_[number]; }
  const Block* find(const Cell& origin) const;
  bool contains(const Cell& cell) const;

  /// use(block, cells) for each block with cells in the box, and those cells, until it returns
  /// false: then false too. Cost: by blocks that the box touches, but never more than all.
  template <class Use>
  bool for_each_block(const CellBox& box, const Use& use) const;
  /// use(cell, number) for each cell in the box.
  template <class Use>
  void for_each(const CellBox& box, const Use& use) const {
    for_each_block(box, [&](const Block& block, const CellMask& cells) {
      cells.for_each_ranked(block.cells, [&](BlockPosition position, std::uint32_t rank) {
        use(Cell(block.origin + block_offset(position)), block.first + rank);
      });
      return true;
    });
  }

  bool overlaps(const CellBox& box) const {
    return !for_each_block(box, [](const Block&, const CellMask&) { return false; });
  }
  std::int64_t count(const CellBox& box) const {
    std::int64_t count = 0;
    for_each_block(box, [&](const Block&, const CellMask& cells) {
      count += cells.count();
      return true;
    });
    return count;
  }
  /// Whether all cells of the box are in the set.
  bool holds(const CellBox& box) const;

  /// The set of all cells at most `cells` (Chebyshev) from one of this, with one point each.
  CellBlocks dilated(int cells) const;

 private:
  std::uint32_t block_at(const Cell& origin);
  void number_cells();
  void dilate_along(int axis);

  std::vector<Block> blocks_;
  CellPlaces places_;
  std::vector<std::uint32_t> points_;
  CellBox bounds_;
};

/// The box of the cells of a block, which has some.
CellBox bounds_of(const CellBlocks::Block& block);

template <class Use>
bool CellBlocks::for_each_block(const CellBox& box, const Use& use) const {
  const CellBox region = intersection(box, bounds_);
  if (region.empty()) return true;
  const auto visit = [&](const Block& block) {
    const CellMask cells = block.cells & positions_in(block.origin, region);
    return cells.none() || use(block, cells);
  };
  const Cell first = block_origin(region.min);
  const Cell last = block_origin(region.max - Cell::Ones());
  // In double: from one end of the indices to the other lie more blocks than 64 bits count.
  const Eigen::Vector3d steps =
      (last.cast<double>() - first.cast<double>()) / kBlockEdge + Eigen::Vector3d::Ones();
  if (steps.prod() > static_cast<double>(blocks_.size())) {
    for (const Block& block : blocks_) {
      const CellBox cells{.min = block.origin, .max = block.origin + Cell::Constant(kBlockEdge)};
      if (cells.overlaps(region) && !visit(block)) return false;
    }
    return true;
  }
  return for_each_block_of(region, [&](const Cell& origin) {
    const Block* block = find(origin);
    return block == nullptr || visit(*block);
  });
}

}  // namespace rmap
