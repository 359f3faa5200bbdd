#include "grid/block_store.hpp"

#include <algorithm>
#include <hwy/cache_control.h>
#include <limits>

#include <fmt/format.h>

namespace rmap {

namespace {

// So many blocks take a beam as long as the R-tree does.
constexpr int kMostSteps = 256;
constexpr std::size_t kCacheLine = 64 / sizeof(Value);

}  // namespace

static_assert(packed_block::kMaxLength <= ValuePool::kMaxCount);

BlockStore::BlockStore(const Options& options) : LeafStore(options, kBlockEdge), blocks_(1) {}

std::unique_ptr<LeafStore> BlockStore::clone() const { return std::make_unique<BlockStore>(*this); }

std::optional<LeafId> BlockStore::find(const Cell& origin) const {
  return table_.find(origin, origins());
}

void BlockStore::visit_block(const Cell& block,
                             FunctionRef<void(LeafId, const Cell& origin)> visit) const {
  if (const auto id = find(block)) visit(*id, block);
}

const Value* BlockStore::find_value(const Cell& cell) const {
  const auto id = find(block_origin(cell));
  return id ? packed_block::find(run(*id), block_position(cell)) : nullptr;
}

// Near the origin nearly all nodes of the R-tree may be crossed: there the beam is followed
// from block to block. Beyond, in a map that is large and mostly empty, the R-tree is faster.
void BlockStore::visit_along(const Beam& beam, VisitAlong visit) const {
  if (leaf_count() == 0) return;
  double limit = std::numeric_limits<double>::infinity();
  BeamWalk walk(beam, leaf_bounds(), kBlockEdge);
  for (int steps = 0; walk.more() && walk.enter() < limit; ++steps, walk.advance()) {
    if (steps == kMostSteps) break;
    const auto id = find(walk.cell());
    if (id) limit = std::min(limit, visit(leaf(*id, walk.cell()), walk.enter()));
  }
  if (!walk.more() || walk.enter() >= limit) return;
  LeafStore::visit_along(beam, [&, from = walk.enter()](const Leaf& leaf, double enter) {
    if (enter >= from) limit = std::min(limit, visit(leaf, enter));
    return limit;
  });
}

Leaf BlockStore::leaf(LeafId id, const Cell& origin) const {
  return {.origin = origin, .edge = kBlockEdge, .content = run(id)};
}

LeafStore::Content BlockStore::content(LeafId id) {
  Value* const packed = run(id);
  return {.cells = packed_block::cells(packed), .values = packed_block::values(packed)};
}

void BlockStore::prefetch(LeafId id) const {
  const Value* const packed = run(id);
  hwy::Prefetch(packed);
  hwy::Prefetch(packed + kCacheLine);
}

BytesInUse BlockStore::bytes_in_use() const {
  return {.nodes = tree().bytes_in_use(),
          .blocks = blocks_.bytes_in_use() + table_.bytes_in_use(),
          .values = runs_.bytes_in_use()};
}

LeafId BlockStore::allocate(const Cell& origin) {
  const LeafId id = blocks_.allocate();
  *blocks_.record(id) = {.run = kNoRun, .stamp = 0, .origin = {origin.x(), origin.y(), origin.z()}};
  return id;
}

void BlockStore::release(LeafId id) {
  table_.remove(origins()(id), origins());
  blocks_.release(id);
}

void BlockStore::add_cells(LeafId id, const CellMask& cells, Value value) {
  if (blocks_.record(id)->run == kNoRun) {
    std::fill_n(replace(id, {}, cells), cells.count(), value);
    // Only now, when nothing of the leaf is missing: whoever finds it may read it.
    table_.add(origins()(id), id, origins());
    return;
  }
  const auto [before, old_values] = content(id);
  std::array<Value, kBlockCells + 1> kept;
  const std::uint32_t count = before.count();
  std::copy_n(old_values, count, kept.begin());
  kept[count] = value;  // is read once more when all old ones have been taken
  CellMask after = before;
  after |= cells;
  Value* const values = replace(id, before, after);
  // Without a branch: nothing foretells which cells are new.
  after.for_each([&, old_cells = before, next_old = kept.data(),
                  next = values](BlockPosition position) mutable {
    const bool is_old = old_cells.test(position);
    const Value old = *next_old;
    *next++ = is_old ? old : value;
    next_old += is_old ? 1 : 0;
  });
}

void BlockStore::take_cells(LeafId id, const CellMask& cells) {
  const auto [before, old_values] = content(id);
  std::array<Value, kBlockCells> kept;
  std::uint32_t count = 0;
  before.for_each([&, next = old_values](BlockPosition position) mutable {
    if (!cells.test(position)) kept[count++] = *next;
    ++next;
  });
  const CellMask after = before.without(cells);
  if (after.none()) {
    runs_.release(blocks_.record(id)->run, packed_block::length(before));
    blocks_.record(id)->run = kNoRun;
    return;
  }
  std::copy_n(kept.begin(), count, replace(id, before, after));
}

Value* BlockStore::replace(LeafId id, const CellMask& before, const CellMask& after) {
  ValuePool::Handle& handle = blocks_.record(id)->run;
  const std::uint32_t length = packed_block::length(after);
  if (handle == kNoRun) {
    handle = runs_.allocate(length);
  } else if (const std::uint32_t old = packed_block::length(before);
             !ValuePool::same_size(old, length)) {
    const ValuePool::Handle other = runs_.allocate(length);
    runs_.release(handle, old);
    handle = other;
  }
  packed_block::write_cells(runs_.at(handle), after);
  return packed_block::values(runs_.at(handle));
}

std::optional<std::string> BlockStore::check_storage() const {
  if (blocks_.size() != leaf_count()) {
    return fmt::format("the R-tree has {} leaf branches, but there are {} blocks", leaf_count(),
                       blocks_.size());
  }
  if (table_.size() != leaf_count()) {
    return fmt::format("the R-tree has {} leaf branches, but the table has {} blocks", leaf_count(),
                       table_.size());
  }
  std::optional<std::string> broken;
  visit(all_cells(), [&](LeafId id, const Leaf& leaf) {
    if (find(leaf.origin) != id) {
      broken = fmt::format("the table does not have the block at ({}, {}, {})", leaf.origin.x(),
                           leaf.origin.y(), leaf.origin.z());
    }
    return !broken.has_value();
  });
  return broken;
}

}  // namespace rmap
