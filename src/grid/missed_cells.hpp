#pragma once

#include "grid/beam_groups.hpp"
#include "grid/leaf_marks.hpp"
#include "grid/scan_beams.hpp"

#include <span>
#include <vector>

#include <rmap/value.hpp>

namespace rmap {

/// Whether the beams of a group are cast inversely, or followed one by one.
bool casts_inversely(const BeamGroup& group, const Options& options);

/// The existing cells that beams cross, each group by the traversal that suits it, but for
/// those in `hit` and, it may be, those that a miss cannot change; each leaf once.
std::vector<MarkedLeaf> missed_cells(const LeafStore& store, const UpdateRule& rule,
                                     const ScanBeams& beams, std::span<const BeamGroup> groups,
                                     const LeafMarks& hit);

}  // namespace rmap
