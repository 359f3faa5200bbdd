#include "evaluation/map_under_test.hpp"

#include <rmap/cells.hpp>

namespace rmap::evaluation {

void RmapMap::prepare(const Scan& scan) {
  if (history_ == History::complete) grid_.prepare(scan);
}

void RmapMap::insert(const Scan& scan) { grid_.insert(scan); }

std::size_t RmapMap::extract() const {
  std::size_t count = 0;
  for_each_cell(grid_, {.occupied_only = true}, [&](const Cell&, Value) {
    ++count;
    return true;
  });
  return count;
}

std::optional<double> RmapMap::probability(const Cell& cell) const {
  const std::optional<Value> value = grid_.cell_value(cell);
  return value ? std::optional(probability_of(*value)) : std::nullopt;
}

std::vector<Cell> RmapMap::occupied_cells() const {
  std::vector<Cell> occupied;
  for (const auto& [cell, value] : cells(grid_, {.occupied_only = true})) occupied.push_back(cell);
  return occupied;
}

}  // namespace rmap::evaluation
