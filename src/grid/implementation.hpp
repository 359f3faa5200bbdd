#pragma once

#include "grid/change_log.hpp"
#include "grid/leaf_store.hpp"

#include <rmap/grid.hpp>

namespace rmap {

/// What is inside a grid. The verbs that change it have files of their own:
/// insert.cpp, change.cpp, merge.cpp.
class Grid::Implementation {
 public:
  explicit Implementation(const Options& grid_options);
  Implementation(const Implementation& other);
  Implementation& operator=(const Implementation&) = delete;

  /// Raises the revision. Every mutation starts with it.
  void begin_mutation();
  /// Notes that cells appeared in a leaf.
  void count_new_cells(std::uint32_t cells);

  /// Replaces the value of each cell in `cells`, all of which the leaf has, by
  /// change(cell, value); notes what changed and returns how many values did.
  /// `created`: cells that did not exist before this mutation.
  template <class Change>
  std::uint64_t update(LeafId id, const Cell& origin, const CellMask& cells,
                       const CellMask& created, Change&& change);

  /// Removes the cells of `region` for which drop(value) holds; returns how many.
  std::size_t remove_cells(const CellBox& region, FunctionRef<bool(Value)> drop);

  Options options;
  Lattice lattice;
  UpdateRule rule;
  std::unique_ptr<LeafStore> store;
  ChangeLog log;
  std::size_t cell_count = 0;
  std::vector<Pose> scan_poses;
  History history = History::complete;
};

template <class Change>
std::uint64_t Grid::Implementation::update(LeafId id, const Cell& origin, const CellMask& cells,
                                           const CellMask& created, Change&& change) {
  const CellMask existing = *store->leaf(id, origin).cells;
  const std::span<Value> values = store->values(id);
  std::uint64_t changed = 0;
  cells.for_each([&](BlockPosition position) {
    Value& value = values[existing.rank(position)];
    const Cell cell = origin + block_offset(position);
    const Value before = value;
    const bool is_new = created.test(position);
    value = change(cell, before);
    if (value != before || is_new) ++changed;
    if (rule.occupied(value) != (!is_new && rule.occupied(before))) log.flipped(cell);
  });
  if (changed > 0) store->set_stamp(id, log.stamp());
  return changed;
}

}  // namespace rmap
