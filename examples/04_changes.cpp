// Following a map as it changes: what a planner or a viewer reads after each scan.
#include <iostream>

#include <rmap/rmap.hpp>

int main() {
  // A cart drives through a yard and is gone in the end.
  const rmap::Simulation yard = rmap::make_simulation("moving");

  rmap::Grid grid({.resolution = 0.1});
  grid.track_flips(100'000);  // remember that many flips between occupied and not
  std::uint64_t seen = grid.revision();
  for (std::size_t i = 0; i < yard.size(); ++i) {
    grid.insert(yard.scan(i));
    if (i % 5 != 4) continue;

    const rmap::Changes changes = grid.changes_since(seen);
    seen = changes.revision;
    std::size_t occupied = 0;
    for (const rmap::CellState& cell : changes.cells) occupied += cell.occupied ? 1 : 0;
    std::cout << "after " << yard.time(i) << " s: " << changes.blocks.size() << " blocks changed; "
              << occupied << " cells became occupied, " << changes.cells.size() - occupied
              << " free"
              << (changes.complete ? "\n"
                                   : " (all cells of these blocks: the journal is too short)\n");
  }

  // A copy is a snapshot; the original goes on alone.
  const rmap::Grid snapshot = grid;
  const std::size_t erased = grid.erase({.min = {-1, -1, 0}, .max = {1, 1, 2}});
  std::cout << "erased " << erased << " cells: " << grid.cell_count() << " are left, "
            << snapshot.cell_count() << " in the snapshot\n";
}
