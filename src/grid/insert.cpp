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
    ensured.cells += leaf.cells.count();
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
  // In Morton order the R-tree grows alike whatever the order of the points.
  std::sort(missing.begin(), missing.end(), [](const MarkedLeaf& a, const MarkedLeaf& b) {
    return morton_less(a.origin, b.origin);
  });
  store->add_leaves(missing, rule.prior());
  for (const MarkedLeaf& leaf : missing) note(leaf, leaf.cells.count());
  return ensured;
}

PrepareReport Grid::prepare(const Scan& scan) {
  Implementation& grid = *implementation_;
  const ScanBeams beams(scan, grid.lattice, grid.options);
  const EndCells ends = gather_end_cells(beams, groups_by_origin(beams), nullptr);

  grid.begin_mutation();
  const auto ensured = grid.ensure(ends.cells);
  return {.points = beams.size(),
          .skipped = ends.skipped,
          .end_cells = ensured.cells,
          .new_cells = ensured.new_cells};
}

InsertReport Grid::insert(const Scan& scan) {
  Implementation& grid = *implementation_;
  const ScanBeams beams(scan, grid.lattice, grid.options);
  std::vector<BeamGroup> groups = groups_by_origin(beams);
  const bool chooses = grid.options.beams == Beams::per_end_cell;
  std::optional<BeamIndex> index;
  if (groups.size() == 1 && !chooses && casts_inversely(groups.front(), grid.options)) {
    index.emplace(index_for(beams, groups.front()));
  }
  const EndCells ends = gather_end_cells(beams, groups, index ? &*index : nullptr);
  if (chooses) groups = groups_by_origin(beams, ends.chosen);

  grid.begin_mutation();
  // After preparation no cells are to come: whatever is done from here on gains.
  if (grid.scan_poses.empty()) grid.store->repack();
  grid.scan_poses.push_back(scan.map_from_sensor);
  auto ensured = grid.ensure(ends.cells);
  const LeafMarks hit(grid.store->id_limit(), std::move(ensured.leaves));
  const std::uint64_t hits =
      grid.update_all(hit.marked(), [&](Value value) { return grid.rule.hit(value); });
  const MissedCells missed(*grid.store, grid.rule, beams, hit);
  const std::uint64_t misses = grid.update_all(index ? missed.of(*index) : missed.of(groups),
                                               [&](Value value) { return grid.rule.miss(value); });
  return {.points = beams.size(),
          .inserted = ends.inserted,
          .cut = ends.cut,
          .skipped = ends.skipped,
          .end_cells = ensured.cells,
          .new_cells = ensured.new_cells,
          .hits = hits,
          .misses = misses};
}

}  // namespace rmap
