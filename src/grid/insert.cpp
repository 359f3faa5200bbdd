#include <algorithm>
#include <unordered_map>

#include "grid/forward/crossed_cells.hpp"
#include "grid/implementation.hpp"
#include "grid/sorted_scan.hpp"

namespace rmap {

namespace {

struct LeafCells {
  Cell origin;
  CellMask cells;
};

// Cells gathered by leaf, in Morton order: the R-tree grows alike whatever the
// order of the points.
std::vector<LeafCells> by_leaf(const std::vector<Cell>& cells, const LeafStore& store) {
  std::vector<LeafCells> leaves;
  std::unordered_map<Cell, std::size_t, CellHash> places;
  std::size_t place = 0;
  for (const Cell& cell : cells) {
    const Cell origin = store.origin_of(cell);
    // Neighbouring points mostly lie in one leaf.
    if (leaves.empty() || leaves[place].origin != origin) {
      place = places.try_emplace(origin, leaves.size()).first->second;
      if (place == leaves.size()) leaves.push_back({origin, {}});
    }
    leaves[place].cells.set(store.position_of(cell));
  }
  std::sort(leaves.begin(), leaves.end(), [](const LeafCells& a, const LeafCells& b) {
    return morton_less(a.origin, b.origin);
  });
  return leaves;
}

}  // namespace

PrepareReport Grid::prepare(const Scan& scan) {
  Implementation& grid = *implementation_;
  const SortedScan beams = sorted(scan, grid.lattice, grid.options, Content::end_cells);
  PrepareReport report{.points = beams.points, .skipped = beams.skipped};

  grid.begin_mutation();
  const Value prior = grid.rule.prior();
  for (const LeafCells& leaf : by_leaf(beams.end_cells, *grid.store)) {
    const auto [id, created] = grid.store->ensure(leaf.origin, leaf.cells, prior);
    grid.update(id, leaf.origin, created, created, [](const Cell&, Value value) { return value; });
    grid.count_new_cells(created.count());
    report.end_cells += leaf.cells.count();
    report.new_cells += created.count();
  }
  return report;
}

InsertReport Grid::insert(const Scan& scan) {
  Implementation& grid = *implementation_;
  SortedScan beams = sorted(scan, grid.lattice, grid.options, Content::end_cells_and_beams);
  if (grid.options.beams == Beams::per_end_cell) keep_one_beam_per_end_cell(beams.beams);
  InsertReport report{.points = beams.points,
                      .inserted = beams.end_cells.size(),
                      .cut = beams.cut,
                      .skipped = beams.skipped};

  grid.begin_mutation();
  grid.scan_poses.push_back(scan.map_from_sensor);

  struct EndLeaf {
    LeafId id;
    Cell origin;
    CellMask cells;
    CellMask created;
  };
  std::vector<EndLeaf> ends;
  for (const LeafCells& leaf : by_leaf(beams.end_cells, *grid.store)) {
    const auto [id, created] = grid.store->ensure(leaf.origin, leaf.cells, grid.rule.prior());
    ends.push_back({id, leaf.origin, leaf.cells, created});
    grid.count_new_cells(created.count());
    report.end_cells += leaf.cells.count();
    report.new_cells += created.count();
  }
  LeafMarks hit(grid.store->id_limit());
  for (const EndLeaf& end : ends) {
    hit.at(end.id, end.origin) = end.cells;
    report.hits += grid.update(end.id, end.origin, end.cells, end.created,
                               [&](const Cell&, Value value) { return grid.rule.hit(value); });
  }

  const LeafMarks crossed = crossed_cells(*grid.store, beams.beams, hit, grid.options.threads);
  for (const LeafMarks::Marked& leaf : crossed.marked()) {
    report.misses += grid.update(leaf.id, leaf.origin, leaf.cells, {}, [&](const Cell&, Value value) {
      return grid.rule.miss(value);
    });
  }
  return report;
}

}  // namespace rmap
