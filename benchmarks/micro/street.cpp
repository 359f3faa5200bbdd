#include "micro/street.hpp"

#include <rmap/cells.hpp>
#include <rmap/simulation.hpp>

namespace rmap::bench {

const std::vector<Scan>& street_scans() {
  static const std::vector<Scan> kScans = [] {
    std::vector<Scan> scans;
    for (const Scan& scan : make_simulation("street", {.scans = 6})) scans.push_back(scan);
    return scans;
  }();
  return kScans;
}

std::size_t street_beams() {
  std::size_t beams = 0;
  for (const Scan& scan : street_scans()) beams += scan.points.size() + scan.no_returns.size();
  return beams;
}

Grid street_map(const Options& options) {
  Grid grid(options);
  for (const Scan& scan : street_scans()) grid.prepare(scan);
  for (const Scan& scan : street_scans()) grid.insert(scan);
  return grid;
}

const std::vector<Cell>& street_surface() {
  static const std::vector<Cell> kCells = [] {
    const Grid grid = street_map();
    std::vector<Cell> occupied;
    for (const auto& [cell, value] : cells(grid, {.occupied_only = true})) {
      occupied.push_back(cell);
    }
    return occupied;
  }();
  return kCells;
}

}  // namespace rmap::bench
