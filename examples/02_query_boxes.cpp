// One map, every resolution: the occupancy of cuboids [RMAP 2.2].
#include <algorithm>
#include <iostream>

#include <rmap/rmap.hpp>

int main() {
  rmap::Grid grid({.resolution = 0.1});
  for (const rmap::Scan& scan : rmap::make_simulation("street", {.scans = 3})) grid.insert(scan);

  // Where is room to park? In cuboids of 6 m along the kerb the mean over all cells says how full
  // a cuboid is, the largest probability whether there is anything in it at all.
  for (const double x : {0, 6, 12, 18}) {
    const rmap::Box lot{.min = {x, -4.6, 0.3}, .max = {x + 6, -3.0, 1.5}};
    const rmap::BoxOccupancy found = rmap::box_occupancy(grid, lot);
    std::cout << "x from " << x << " to " << x + 6 << " m: mean " << found.mean << ", largest "
              << found.max << ", " << found.occupied << " of " << found.cells << " cells occupied: "
              << (rmap::box_occupied(grid, lot, rmap::Criterion::max) ? "taken" : "free") << "\n";
  }

  // The whole map at 4 times the cell size.
  const rmap::Grid coarse = rmap::coarsen(grid, 4, rmap::Criterion::max);
  std::cout << grid.cell_count() << " cells of 0.1 m are " << coarse.cell_count() << " of "
            << coarse.options().resolution << " m\n";

  // Fine near the robot, coarse far away, in one pass: cubes may grow with the distance
  // of their nearest point.
  const rmap::Vector3d robot(0, 0, 1);
  const auto cuboids = rmap::cells_at(
      grid, [&](const rmap::Box& place) { return 0.05 * (place.nearest(robot) - robot).norm(); });
  const auto [smallest, largest] = std::minmax_element(
      cuboids.begin(), cuboids.end(), [](const rmap::QueryCuboid& a, const rmap::QueryCuboid& b) {
        return a.box.extent().x() < b.box.extent().x();
      });
  std::cout << "near fine and far coarse: " << cuboids.size() << " cubes with edges of "
            << smallest->box.extent().x() << " to " << largest->box.extent().x() << " cells\n";
}
