#include "grid/block_store.hpp"

#include <algorithm>
#include <cassert>

#include <fmt/format.h>

namespace rmap {

BlockStore::BlockStore(const Options& options)
    : LeafStore(options, kBlockEdge), masks_(1), blocks_(1) {}

std::unique_ptr<LeafStore> BlockStore::clone() const { return std::make_unique<BlockStore>(*this); }

Leaf BlockStore::leaf(LeafId id, const Cell& origin) const {
  return {.origin = origin,
          .edge = kBlockEdge,
          .cells = masks_.record(id),
          .values = values_.at(blocks_.record(id)->values)};
}

std::span<Value> BlockStore::values(LeafId id) {
  return {values_.at(blocks_.record(id)->values), masks_.record(id)->count()};
}

BytesInUse BlockStore::bytes_in_use() const {
  return {.nodes = tree_bytes(),
          .blocks = masks_.bytes_in_use() + blocks_.bytes_in_use(),
          .values = values_.bytes_in_use()};
}

LeafId BlockStore::allocate() {
  const LeafId id = masks_.allocate();
  [[maybe_unused]] const LeafId same = blocks_.allocate();
  assert(same == id);
  *masks_.record(id) = {};
  *blocks_.record(id) = {.values = 0, .stamp = 0};
  return id;
}

void BlockStore::release(LeafId id) {
  masks_.release(id);
  blocks_.release(id);
}

void BlockStore::add_cells(LeafId id, const CellMask& cells, Value value) {
  CellMask& mask = *masks_.record(id);
  Block& block = *blocks_.record(id);
  const CellMask before = mask;
  const std::uint32_t old_count = before.count();
  mask |= cells;
  const std::uint32_t new_count = mask.count();

  std::array<Value, kBlockCells> old_values;
  if (old_count > 0) std::copy_n(values_.at(block.values), old_count, old_values.begin());
  if (old_count == 0 || !ValuePool::same_size(old_count, new_count)) {
    const ValuePool::Handle longer = values_.allocate(new_count);
    if (old_count > 0) values_.release(block.values, old_count);
    block.values = longer;
  }
  const Value* next_old = old_values.data();
  Value* next = values_.at(block.values);
  mask.for_each(
      [&](BlockPosition position) { *next++ = before.test(position) ? *next_old++ : value; });
}

void BlockStore::take_cells(LeafId id, const CellMask& cells) {
  CellMask& mask = *masks_.record(id);
  Block& block = *blocks_.record(id);
  const std::uint32_t old_count = mask.count();
  const ValuePool::Handle old_run = block.values;

  std::array<Value, kBlockCells> kept;
  std::uint32_t new_count = 0;
  const Value* next = values_.at(old_run);
  mask.for_each([&](BlockPosition position) {
    if (!cells.test(position)) kept[new_count++] = *next;
    ++next;
  });
  mask = mask.without(cells);

  if (new_count == 0 || !ValuePool::same_size(old_count, new_count)) {
    values_.release(old_run, old_count);
    if (new_count == 0) return;
    block.values = values_.allocate(new_count);
  }
  std::copy_n(kept.begin(), new_count, values_.at(block.values));
}

std::optional<std::string> BlockStore::check_storage() const {
  if (masks_.size() != leaf_count() || blocks_.size() != leaf_count()) {
    return fmt::format("the R-tree has {} leaf branches, but there are {} blocks", leaf_count(),
                       masks_.size());
  }
  return std::nullopt;
}

}  // namespace rmap
