// A map from scans, and the questions that a robot asks it.
#include <iostream>

#include <rmap/rmap.hpp>

int main() {
  // A room of 6 x 5 x 2.7 m, seen by a lidar that drives through it. Scans in files are read in
  // the same way: for (const rmap::Scan& scan : rmap::read_scans("street/")) ...
  rmap::Grid grid({.resolution = 0.1});
  for (const rmap::Scan& scan : rmap::make_simulation("room", {.scans = 6})) {
    const rmap::InsertReport report = grid.insert(scan);
    std::cout << scan.name << ": " << report.points << " points, " << report.new_cells
              << " new cells\n";
  }
  std::cout << grid.cell_count() << " cells in " << grid.bytes_in_use().total() / 1024 << " KiB\n";

  // One place. A cell that no beam ever ended in does not exist: it is free by assumption.
  const bool wall = grid.state({3.05, 0.0, 2.4}) == rmap::State::occupied;
  const bool unseen = grid.state({0.0, 0.0, 2.0}) == rmap::State::assumed_free;
  std::cout << "a wall at x = 3.05: " << (wall ? "yes" : "no") << "\n"
            << "no cell in mid air: " << (unseen ? "yes" : "no") << "\n";

  // A cuboid: the mean over all cells in it, absent ones as free [RMAP eq. 1].
  const double p = rmap::probability(grid, {.min = {2.8, -1, 2.2}, .max = {3.2, 1, 2.6}});
  std::cout << "mean probability around it: " << p << "\n";

  // What a beam straight ahead would meet.
  if (const auto hit = rmap::cast_ray(grid, {0, 0, 2.4}, {1, 0, 0}, 30.0)) {
    std::cout << "the ray ahead ends after " << hit->distance << " m\n";
  }

  rmap::save(grid, "room.rmap");
  std::cout << "saved as room.rmap\n";
}
