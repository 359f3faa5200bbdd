#include "grid/cell_store.hpp"

#include <cassert>
#include <hwy/cache_control.h>

#include <fmt/format.h>

namespace rmap {

namespace {

// A leaf of one cell always has just that cell.
constexpr CellMask kOneCell = CellMask::single(0);

}  // namespace

CellStore::CellStore(const Options& options) : LeafStore(options, 1), entries_(1) {}

std::unique_ptr<LeafStore> CellStore::clone() const { return std::make_unique<CellStore>(*this); }

std::optional<LeafId> CellStore::find(const Cell& origin) const {
  const LeafId* const id = tree().find(leaf_box(origin));
  if (id == nullptr) return std::nullopt;
  return *id;
}

void CellStore::visit_block(const Cell& block,
                            FunctionRef<void(LeafId, const Cell& origin)> visit) const {
  tree().overlapping({.min = block, .max = block + Cell::Constant(kBlockEdge)},
                     [&](const CellBox& box, LeafId id) { visit(id, box.min); });
}

const Value* CellStore::find_value(const Cell& cell) const {
  const auto id = find(cell);
  return id ? &entries_.record(*id)->value : nullptr;
}

Leaf CellStore::leaf(LeafId id, const Cell& origin) const {
  return {.origin = origin, .edge = 1, .content = &entries_.record(id)->value};
}

LeafStore::Content CellStore::content(LeafId id) {
  return {.cells = kOneCell, .values = &entries_.record(id)->value};
}

void CellStore::prefetch(LeafId id) const { hwy::Prefetch(entries_.record(id)); }

BytesInUse CellStore::bytes_in_use() const {
  return {.nodes = tree().bytes_in_use(), .values = entries_.bytes_in_use()};
}

LeafId CellStore::allocate(const Cell& /*origin*/) {
  const LeafId id = entries_.allocate();
  *entries_.record(id) = {.stamp = 0, .value = 0};
  return id;
}

void CellStore::release(LeafId id) { entries_.release(id); }

void CellStore::add_cells(LeafId id, const CellMask& cells, Value value) {
  assert(cells == kOneCell);
  static_cast<void>(cells);
  entries_.record(id)->value = value;
}

// Nothing to do: the cell goes with its leaf.
void CellStore::take_cells(LeafId /*id*/, const CellMask& /*cells*/) {}

std::optional<std::string> CellStore::check_storage() const {
  if (entries_.size() != leaf_count()) {
    return fmt::format("the R-tree has {} leaf branches, but there are {} cells", leaf_count(),
                       entries_.size());
  }
  return std::nullopt;
}

}  // namespace rmap
