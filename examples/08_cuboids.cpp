// A map as few cuboids: how many, with which error, and in an R-tree for collision checks.
#include <cstdio>

#include <rmap/rmap.hpp>

int main() {
  rmap::Grid grid({.resolution = 0.05});
  for (const rmap::Scan& scan : rmap::make_simulation("room")) grid.insert(scan);
  const auto cells = rmap::occupied_cells(grid);

  for (const char* preset : {"exact", "default", "compact", "sketch"}) {
    const auto [cuboids, report] = rmap::approximate(cells, rmap::approximation_preset(preset));
    const rmap::CuboidError error = rmap::cuboid_error(cells, cuboids);
    std::printf("%-8s %5zu cuboids for %zu cells: %4.1f %% false, %4.1f %% lost\n", preset,
                cuboids.size(), cells.size(), 100 * error.false_share(),
                100.0 * static_cast<double>(error.lost_cells) / static_cast<double>(error.cells));
  }

  // The presets but sketch lose nothing: what no cuboid overlaps is free.
  const auto compact = rmap::approximate(cells, rmap::approximation_preset("compact")).cuboids;
  const auto tree = rmap::cuboid_tree(compact);
  const rmap::CellBox robot =
      grid.lattice().cells_of({.min = {-0.3, -0.3, 0.1}, .max = {0.3, 0.3, 1.2}});
  const bool free =
      tree.overlapping(robot, [](const rmap::CellBox&, std::uint32_t) { return false; });
  std::printf("the middle of the room is %s\n", free ? "free" : "not free");

  // What has been seen since changes a few cuboids only.
  rmap::CuboidMap kept(grid, {.outer = 1});
  grid.track_flips(1000);
  for (int x = 0; x < 4; ++x) grid.set({x, 0, 10}, 0.9);
  kept.update(grid.changes_since(kept.revision()));
  std::printf("%zu cuboids after a change\n", kept.size());
}
