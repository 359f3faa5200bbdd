#include "approximation/plain_cells.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rmap::test {

namespace {

std::string text(const Cell& cell) {
  return fmt::format("({}, {}, {})", cell.x(), cell.y(), cell.z());
}

}  // namespace

CellBox grown(const CellBox& box, std::int32_t cells) {
  return {.min = (box.min.array() - cells).matrix(), .max = (box.max.array() + cells).matrix()};
}

CellSet set_of(std::span<const Cell> cells) { return {cells.begin(), cells.end()}; }

CellSet set_of(std::span<const CountedCell> cells) {
  CellSet set;
  for (const CountedCell& entry : cells) set.insert(entry.cell);
  return set;
}

CellSet union_of(std::span<const CellBox> boxes) {
  CellSet set;
  for (const CellBox& box : boxes) {
    for_each_cell_in(box, [&](const Cell& cell) { set.insert(cell); });
  }
  return set;
}

std::vector<CellBox> boxes_of(std::span<const Cuboid> cuboids) {
  std::vector<CellBox> boxes;
  for (const Cuboid& cuboid : cuboids) boxes.push_back(cuboid.cells);
  return boxes;
}

CellSet dilated(const CellSet& cells, std::int32_t distance) {
  CellSet set;
  for (const Cell& cell : cells) {
    for_each_cell_in(grown(box_of(cell), distance), [&](const Cell& near) { set.insert(near); });
  }
  return set;
}

bool holds(const CellSet& cells, const CellBox& box) {
  bool all = true;
  for_each_cell_in(box, [&](const Cell& cell) { all = all && cells.contains(cell); });
  return all;
}

std::int64_t distance(const Cell& cell, const CellBox& box) {
  std::int64_t farthest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t below = std::int64_t{box.min[axis]} - cell[axis];
    const std::int64_t above = std::int64_t{cell[axis]} - (box.max[axis] - 1);
    farthest = std::max({farthest, below, above});
  }
  return farthest;
}

std::string violation(const CellSet& cells, std::span<const CellBox> boxes, int outer, int inner) {
  const CellSet allowed = dilated(cells, outer);
  CellSet near;
  for (const CellBox& box : boxes) {
    if (box.empty()) return "a box is empty";
    if (!holds(allowed, box)) {
      return fmt::format("the box {} to {} is too far out", text(box.min), text(box.max));
    }
    for_each_cell_in(grown(box, inner), [&](const Cell& cell) { near.insert(cell); });
  }
  for (const Cell& cell : cells) {
    if (!near.contains(cell)) return fmt::format("no box is near {}", text(cell));
  }
  return {};
}

std::string overlap(std::span<const CellBox> boxes) {
  CellSet seen;
  std::string found;
  for (const CellBox& box : boxes) {
    for_each_cell_in(box, [&](const Cell& cell) {
      if (!seen.insert(cell).second) found = fmt::format("{} is in two boxes", text(cell));
    });
  }
  return found;
}

}  // namespace rmap::test
