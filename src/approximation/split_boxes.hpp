#pragma once

#include <span>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/counted_cells.hpp>

namespace rmap {

/// Cuts the box of the cells in two where its parts, shrunk to their cells, lose most volume, and
/// goes on with the parts down to full ones; then joins parts again, those that cost least empty
/// volume for each box saved, as long as at most the share `max_false` of the volume is empty.
/// Disjoint boxes that hold all cells.
std::vector<CellBox> split_boxes(std::span<const CountedCell> cells, double max_false);

}  // namespace rmap
