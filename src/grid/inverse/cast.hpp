#pragma once

#include "grid/inverse/beam_index.hpp"
#include "grid/leaf_marks.hpp"
#include "grid/scan_beams.hpp"

#include <vector>

#include <rmap/value.hpp>

namespace rmap {

/// Inverse beam casting: instead of following the beams through free space, asks
/// each existing cell in view whether one of them crosses it. Finds the cells
/// that the forward traversal does, but for those in `hit` and those that are
/// settled, which a miss cannot change. Each leaf comes once.
/// Cost: by cells in view that are not settled; neither by the length of the
/// beams nor, beyond the descent, by the size of the map.
std::vector<MarkedLeaf> cast(const LeafStore& store, const ScanBeams& beams, const BeamIndex& index,
                             const LeafMarks& hit, const UpdateRule& rule, int threads);

}  // namespace rmap
