#include "approximation/cell_blocks.hpp"

#include <algorithm>
#include <limits>

namespace rmap {

CellBox bounds_of(const CellBlocks::Block& block) {
  Cell low = Cell::Constant(kBlockEdge);
  Cell high = Cell::Zero();
  block.cells.for_each([&](BlockPosition position) {
    const Cell offset = block_offset(position);
    low = low.cwiseMin(offset);
    high = high.cwiseMax(offset);
  });
  return {.min = block.origin + low, .max = block.origin + high + Cell::Ones()};
}

CellBlocks::CellBlocks(std::span<const CountedCell> cells) {
  check_cells(cells);
  std::uint32_t at = 0;
  for (const CountedCell& counted : cells) {
    const Cell origin = block_origin(counted.cell);
    if (blocks_.empty() || blocks_[at].origin != origin) at = block_at(origin);
    blocks_[at].cells.set(block_position(counted.cell));
  }
  number_cells();
  const Block* block = nullptr;
  for (const CountedCell& counted : cells) {
    const Cell origin = block_origin(counted.cell);
    if (block == nullptr || block->origin != origin) block = find(origin);
    std::uint32_t& points = points_[block->first + block->cells.rank(block_position(counted.cell))];
    points += std::min(counted.points, std::numeric_limits<std::uint32_t>::max() - points);
  }
}

std::uint32_t CellBlocks::block_at(const Cell& origin) {
  const std::uint32_t place =
      places_.add(origin, CellPlaces::hash_of(origin),
                  [&](std::uint32_t i) -> const Cell& { return blocks_[i].origin; });
  if (place == blocks_.size()) blocks_.push_back({.origin = origin, .first = 0, .cells = {}});
  return place;
}

void CellBlocks::number_cells() {
  std::uint32_t count = 0;
  bool first = true;
  for (Block& block : blocks_) {
    block.first = count;
    count += block.cells.count();
    const CellBox box = bounds_of(block);
    bounds_ = first ? box : united(bounds_, box);
    first = false;
  }
  points_.assign(count, 0);
}

const CellBlocks::Block* CellBlocks::find(const Cell& origin) const {
  const auto place =
      places_.find(origin, [&](std::uint32_t i) -> const Cell& { return blocks_[i].origin; });
  return place ? &blocks_[*place] : nullptr;
}

bool CellBlocks::contains(const Cell& cell) const {
  const Block* block = find(block_origin(cell));
  return block != nullptr && block->cells.test(block_position(cell));
}

bool CellBlocks::holds(const CellBox& box) const {
  return bounds_.contains(box) && static_cast<double>(count(box)) == box.volume();
}

// By neighbours on one axis after the other: together the Chebyshev ball.
CellBlocks CellBlocks::dilated(int cells) const {
  CellBlocks dilated = *this;
  for (int i = 0; i < cells; ++i) {
    for (int axis = 0; axis < 3; ++axis) dilated.dilate_along(axis);
  }
  dilated.number_cells();
  dilated.points_.assign(dilated.points_.size(), 1);
  return dilated;
}

void CellBlocks::dilate_along(int axis) {
  std::vector<std::pair<Cell, CellMask>> old;
  old.reserve(blocks_.size());
  for (const Block& block : blocks_) old.emplace_back(block.origin, block.cells);
  for (const auto& [origin, cells] : old) {
    CellMask inside = cells;
    CellMask before;
    CellMask behind;
    cells.for_each([&](BlockPosition position) {
      const Cell offset = block_offset(position);
      for (const int step : {-1, 1}) {
        Cell next = offset;
        next[axis] += step;
        CellMask& mask = next[axis] < 0 ? before : next[axis] == kBlockEdge ? behind : inside;
        mask.set(block_position(next));
      }
    });
    blocks_[block_at(origin)].cells |= inside;
    Cell neighbour = origin;
    for (const auto& [mask, step] :
         {std::pair{before, -kBlockEdge}, std::pair{behind, kBlockEdge}}) {
      if (mask.none()) continue;
      neighbour[axis] = origin[axis] + step;
      blocks_[block_at(neighbour)].cells |= mask;
    }
  }
}

}  // namespace rmap
