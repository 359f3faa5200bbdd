#pragma once

#include <span>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/counted_cells.hpp>

namespace rmap {

/// Disjoint boxes whose union is the cells, which come by z, then y, then x, each once: rows along
/// x, equal ones of neighbouring y joined to rectangles, equal ones of neighbouring z to boxes.
std::vector<CellBox> run_boxes(std::span<const CountedCell> cells);

}  // namespace rmap
