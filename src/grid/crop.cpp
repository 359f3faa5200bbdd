#include <rmap/crop.hpp>

namespace rmap {

std::size_t crop(Grid& grid, const Box& box) {
  const CellBox keep = grid.lattice().cells_of(box);
  std::size_t removed = 0;
  // The six slabs around the box.
  for (int axis = 0; axis < 3; ++axis) {
    CellBox below = all_cells();
    CellBox above = all_cells();
    below.max[axis] = keep.min[axis];
    above.min[axis] = keep.max[axis];
    for (const CellBox& slab : {below, above}) {
      if (!slab.empty()) removed += grid.erase_cells(slab);
    }
  }
  return removed;
}

}  // namespace rmap
