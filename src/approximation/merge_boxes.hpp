#pragma once

#include "approximation/cell_blocks.hpp"

#include <span>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// Joins boxes that together hold all of `cells`, two neighbours at a time, those first whose
/// common box adds fewest places to the union of all, until more than the share `max_false` of
/// the union would be empty. Where `allowed` is given, only boxes inside it are made. Boxes that
/// another holds are dropped.
std::vector<CellBox> merge_boxes(const CellBlocks& cells, std::span<const CellBox> boxes,
                                 double max_false, const CellBlocks* allowed);

}  // namespace rmap
