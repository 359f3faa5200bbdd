#pragma once

#include <span>

#include <rmap/beam.hpp>

#include "grid/leaf_marks.hpp"

namespace rmap {

/// Forward traversal: follows each beam through the leaves that it crosses (the
/// R-tree skips the empty space between them) and marks the existing cells that
/// it walks through, but for those in `hit`. The reference for every other
/// traversal. Cost: by beams, and for each by the leaves near it.
LeafMarks crossed_cells(const LeafStore& store, std::span<const Beam> beams, const LeafMarks& hit,
                        int threads);

}  // namespace rmap
