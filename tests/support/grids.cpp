#include "support/grids.hpp"

#include <algorithm>

namespace rmap::test {

std::vector<CellValue> all_cell_values(const Grid& grid) {
  std::vector<CellValue> cells;
  grid.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each([&](const Cell& cell, Value value) { cells.push_back({cell, value}); });
    return true;
  });
  std::sort(cells.begin(), cells.end(),
            [](const CellValue& a, const CellValue& b) { return morton_less(a.cell, b.cell); });
  return cells;
}

Grid clustered_grid(Random& random, const Options& options, int reach) {
  Grid grid(options);
  for (int cluster = 0; cluster < 12; ++cluster) {
    const Cell center = random.cell(-reach, reach);
    for (int i = 0; i < 60; ++i) {
      grid.set(center + random.cell(-4, 4),
               random.chance(0.6) ? random.real(0.5, 1) : random.real(0, 0.5));
    }
  }
  return grid;
}

std::uint64_t map_hash(const Grid& grid) {
  std::uint64_t hash = 0xCBF29CE484222325u;  // FNV-1a over 64-bit words
  const auto add = [&](std::int64_t number) {
    hash = (hash ^ static_cast<std::uint64_t>(number)) * 0x100000001B3u;
    hash ^= hash >> 32;
  };
  for (const CellValue& entry : all_cell_values(grid)) {
    for (const std::int32_t index : entry.cell) add(index);
    add(entry.value);
  }
  return hash;
}

}  // namespace rmap::test
