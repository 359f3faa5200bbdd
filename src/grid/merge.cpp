#include "grid/implementation.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

void require_equal(const char* name, double ours, double theirs) {
  if (ours == theirs) return;
  throw Error(ErrorKind::input,
              fmt::format("the maps cannot be merged: {} is {} in one and {} in the other", name,
                          ours, theirs));
}

}  // namespace

void Grid::merge(const Grid& other) {
  require_equal("resolution", options().resolution, other.options().resolution);
  require_equal("prior", options().prior, other.options().prior);
  if (&other == this) return merge(Grid(other));

  Implementation& grid = *implementation_;
  grid.begin_mutation();
  const bool was_blank = grid.cell_count == 0 && grid.scan_poses.empty();
  const bool adds_scans = !other.scan_poses().empty();

  // The other map may lie in memory another way: its cells come leaf by leaf of this one.
  other.visit_leaves(all_cells(), [&](const Leaf& theirs) {
    theirs.for_each([&](const Cell& cell, Value value) {
      const CellMask one = CellMask::single(grid.store->position_of(cell));
      const Cell origin = grid.store->origin_of(cell);
      const LeafStore::Ensured leaf = grid.store->ensure(origin, one, value);
      const bool is_new = !leaf.created.none();
      grid.cell_count += leaf.created.count();
      grid.update(leaf.id, origin, one, leaf.created, [&](const Cell&, Value ours) {
        return is_new ? value : grid.rule.clamped(ours + value - grid.rule.prior());
      });
    });
    return true;
  });

  const auto poses = other.scan_poses();
  grid.scan_poses.insert(grid.scan_poses.end(), poses.begin(), poses.end());
  if (was_blank) {
    grid.history = other.history();
  } else if (adds_scans || other.cell_count() > 0) {
    // Neither map's scans have seen the cells of the other.
    const bool seen = grid.scan_poses.empty() && other.history() == History::complete;
    if (!seen) grid.history = History::first_hit;
  }
}

}  // namespace rmap
