#include "grid/beam_groups.hpp"
#include "grid/end_cells.hpp"
#include "grid/end_leaves.hpp"
#include "grid/implementation.hpp"
#include "grid/missed_cells.hpp"
#include "grid/scan_beams.hpp"

namespace rmap {

namespace {

// Leaves that can be gone over in the time of a search for one.
constexpr std::size_t kLeavesPerSearch = 8;

}  // namespace

Grid::Implementation::Ensured Grid::Implementation::ensure(const BlockMarks& cells) {
  const EndLeaves end_leaves(*store, cells);
  EndLeaves::Rest rest(end_leaves);
  Ensured ensured;
  // In a map that is small beside the scan, going over the leaves costs less than searches.
  const bool goes_over = store->leaf_count() < kLeavesPerSearch * cells.blocks().size();
  if (goes_over) {
    std::vector<EndLeaves::Met> all_met;
    store->visit(cells.bounds(), [&](LeafId id, const Leaf& leaf) {
      EndLeaves::Met met;
      if (const CellMask* const ends = end_leaves.find(leaf, met)) {
        ensured.leaves.push_back({id, leaf.origin, *ends});
        all_met.push_back(met);
      }
      return true;
    });
    rest.take(all_met);
  }
  std::vector<MarkedLeaf> missing;
  rest.for_each([&](const Cell& origin, const CellMask& marks) {
    const auto id = goes_over ? std::nullopt : store->find(origin);
    if (id) {
      ensured.leaves.push_back({*id, origin, marks});
    } else {
      missing.push_back({0, origin, marks});
    }
  });

  const auto note = [&](LeafId id, const Cell& origin, const CellMask& created) {
    ensured.new_cells += note_new_cells(id, origin, created, rule.prior());
  };
  add_missing(ensured.leaves, rule.prior(), note);
  enter_missing(missing, rule.prior(), note);
  ensured.leaves.insert(ensured.leaves.end(), missing.begin(), missing.end());
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
