#include "rtree/union_volume.hpp"

#include <algorithm>
#include <vector>

namespace rmap {

namespace {

/// Size of the union of the boxes' shadows on `axis` and the axes after it: the axis is cut at
/// all borders, and each slab counts its width times the size of what reaches through it.
CellCount size_from(std::span<const CellBox> boxes, int axis) {
  if (axis == 3) return boxes.empty() ? 0 : 1;
  std::vector<std::int32_t> borders;
  borders.reserve(2 * boxes.size());
  for (const CellBox& box : boxes) {
    borders.push_back(box.min[axis]);
    borders.push_back(box.max[axis]);
  }
  std::sort(borders.begin(), borders.end());
  borders.erase(std::unique(borders.begin(), borders.end()), borders.end());

  CellCount size = 0;
  std::vector<CellBox> through;
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    through.clear();
    for (const CellBox& box : boxes) {
      if (box.min[axis] <= borders[i] && box.max[axis] > borders[i]) through.push_back(box);
    }
    const std::int64_t width = std::int64_t{borders[i + 1]} - borders[i];
    size += static_cast<CellCount>(width) * size_from(through, axis + 1);
  }
  return size;
}

}  // namespace

CellCount cells_in(const CellBox& box) {
  if (box.empty()) return 0;
  const auto edges = box.extent();
  return static_cast<CellCount>(edges.x()) * static_cast<CellCount>(edges.y()) *
         static_cast<CellCount>(edges.z());
}

CellCount cells_in_union(std::span<const CellBox> boxes) { return size_from(boxes, 0); }

}  // namespace rmap
