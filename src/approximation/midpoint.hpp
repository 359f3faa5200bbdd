#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/counted_cells.hpp>

namespace rmap {

/// The paper's recursion [RMAP 2.3]: shrinks a box to its cells, accepts it when these fill at
/// least the share `fill` of it, or when its volume is at most `smallest`, and else halves its
/// longest axis. Disjoint boxes that hold all cells.
std::vector<CellBox> midpoint_boxes(std::span<const CountedCell> cells, double fill,
                                    std::uint64_t smallest);

}  // namespace rmap
