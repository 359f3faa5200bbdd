#include "grid/beam_groups.hpp"
#include "grid/end_cells.hpp"
#include "grid/implementation.hpp"
#include "grid/missed_cells.hpp"
#include "grid/scan_beams.hpp"

#include <utility>

namespace rmap {

Grid::Implementation::Ensured Grid::Implementation::ensure(const BlockMarks& cells) {
  Ensured ensured;
  std::vector<BlockMarks::Block> missing;
  for (const BlockMarks::Block& block : cells.blocks()) {
    CellMask left = block.cells;
    store->visit_block(block.origin, [&](LeafId id, const Cell& origin) {
      if (store->edge() == kBlockEdge) {
        ensured.leaves.push_back({id, origin, left});
        left = {};
      } else if (const BlockPosition position = block_position(origin); left.test(position)) {
        ensured.leaves.push_back({id, origin, CellMask::single(0)});
        left.reset(position);
      }
    });
    if (!left.none()) missing.push_back({block.origin, left});
  }
  const auto note = [&](LeafId id, const Cell& origin, const CellMask& created) {
    ensured.new_cells += note_new_cells(id, origin, created, rule.prior());
  };
  add_missing(ensured.leaves, rule.prior(), note);
  const auto entered = enter_missing(std::move(missing), rule.prior(), note);
  ensured.leaves.insert(ensured.leaves.end(), entered.begin(), entered.end());
  return ensured;
}

Grid::Implementation::Updates Grid::Implementation::insert_by_marks(
    const ScanBeams& beams, std::span<const BeamGroup> groups, const BlockMarks& ends) {
  auto ensured = ensure(ends);
  const LeafMarks hit(store->id_limit(), std::move(ensured.leaves));
  const std::uint64_t hits = update_all(hit.marked(), [&](Value value) { return rule.hit(value); });
  const std::uint64_t misses = update_all(missed_cells(*store, rule, beams, groups, hit),
                                          [&](Value value) { return rule.miss(value); });
  return {.new_cells = ensured.new_cells, .hits = hits, .misses = misses};
}

PrepareReport Grid::prepare(const Scan& scan) {
  Implementation& grid = *implementation_;
  const ScanBeams beams(scan, grid.lattice, grid.options);
  const EndCells ends = gather_end_cells(beams, groups_by_origin(beams), nullptr);

  grid.begin_mutation();
  const auto ensured = grid.ensure(ends.cells);
  return {.points = beams.size(),
          .skipped = ends.skipped,
          .end_cells = ends.cells.count(),
          .new_cells = ensured.new_cells};
}

InsertReport Grid::insert(const Scan& scan) {
  Implementation& grid = *implementation_;
  const ScanBeams beams(scan, grid.lattice, grid.options);
  std::vector<BeamGroup> groups = groups_by_origin(beams);
  const bool chooses = grid.options.beams == Beams::per_end_cell;
  const auto casts = [&] {
    return groups.size() == 1 && casts_inversely(groups.front(), grid.options);
  };
  std::optional<BeamIndex> index;
  if (!chooses && casts()) index.emplace(index_for(beams, groups.front()));
  const EndCells ends = gather_end_cells(beams, groups, index ? &*index : nullptr);
  if (chooses) {
    groups = groups_by_origin(beams, ends.chosen);
    if (casts())
      index_beams(beams, groups.front(), index.emplace(index_for(beams, groups.front())));
  }
  if (index) index->sort(grid.options.threads);

  grid.begin_mutation();
  // After preparation no cells are to come: whatever is done from here on gains.
  if (grid.scan_poses.empty()) grid.store->repack();
  grid.scan_poses.push_back(scan.map_from_sensor);
  const auto updates = index ? grid.insert_inversely(beams, *index, ends.cells)
                             : grid.insert_by_marks(beams, groups, ends.cells);
  return {.points = beams.size(),
          .inserted = ends.inserted,
          .cut = ends.cut,
          .skipped = ends.skipped,
          .end_cells = ends.cells.count(),
          .new_cells = updates.new_cells,
          .hits = updates.hits,
          .misses = updates.misses};
}

}  // namespace rmap
