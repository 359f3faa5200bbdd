#include "grid/beam_groups.hpp"
#include "grid/end_cells.hpp"
#include "grid/implementation.hpp"
#include "grid/missed_cells.hpp"
#include "grid/scan_beams.hpp"

#include <algorithm>

namespace rmap {

Grid::Implementation::Ensured Grid::Implementation::ensure(const BlockMarks& cells) {
  Ensured ensured;
  std::vector<MarkedLeaf> missing;
  ensured.leaves.reserve(cells.blocks().size());
  const auto note = [&](const MarkedLeaf& leaf, std::uint32_t new_cells) {
    ensured.leaves.push_back(leaf);
    if (new_cells == 0) return;
    ensured.new_cells += new_cells;
    store->set_stamp(leaf.id, log.stamp());
    count_new_cells(new_cells);
  };
  const auto sort_out = [&](const Cell& origin, const CellMask& marks) {
    if (const auto id = store->find(origin)) {
      note({*id, origin, marks}, store->add_missing(*id, marks, rule.prior()).count());
    } else {
      missing.push_back({0, origin, marks});
    }
  };
  for (const BlockMarks::Block& block : cells.blocks()) {
    store->for_each_leaf_of(block.origin, block.cells, sort_out);
  }
  enter_missing(missing, rule.prior());
  for (const MarkedLeaf& leaf : missing) note(leaf, leaf.cells.count());
  return ensured;
}

void Grid::Implementation::enter_missing(std::vector<MarkedLeaf>& leaves, Value value) {
  // In Morton order the R-tree grows alike whatever the order of the points.
  std::sort(leaves.begin(), leaves.end(), [](const MarkedLeaf& a, const MarkedLeaf& b) {
    return morton_less(a.origin, b.origin);
  });
  store->add_leaves(leaves, value);
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
