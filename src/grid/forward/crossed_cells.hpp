#pragma once

#include "grid/leaf_marks.hpp"
#include "grid/scan_beams.hpp"

#include <span>

namespace rmap {

/// Forward traversal: follows each beam through the leaves that it crosses (the
/// R-tree skips the empty space between them) and marks the existing cells that
/// it walks through, but for those in `hit`. The reference for every other
/// traversal. `numbers`: those of the beams in the scan. Cost: by beams, and for
/// each by the leaves near it.
LeafMarks crossed_cells(const LeafStore& store, const ScanBeams& beams,
                        std::span<const std::uint32_t> numbers, const LeafMarks& hit, int threads);

}  // namespace rmap
