#pragma once

#include "grid/beam_groups.hpp"
#include "grid/block_marks.hpp"
#include "grid/inverse/beam_index.hpp"

#include <vector>

namespace rmap {

/// Where the beams of a scan end, and which of them clear.
struct EndCells {
  BlockMarks cells;
  std::uint64_t inserted = 0;  ///< points that end in a cell
  std::uint64_t cut = 0;
  SkippedPoints skipped;
  /// With Beams::per_end_cell: the numbers of the beams that clear, ascending.
  std::vector<std::uint32_t> chosen;
};

/// An empty index that gather_end_cells or index_beams can fill with the beams of a group,
/// which must outlive it.
BeamIndex index_for(const ScanBeams& beams, const BeamGroup& group);

/// Sorts out all points of a scan. `index`, when given, takes the beams of the one group.
/// Throws Error(limit) about a bad point when the options say so.
EndCells gather_end_cells(const ScanBeams& beams, std::span<const BeamGroup> groups,
                          BeamIndex* index);

/// Puts the beams of a group into an index.
void index_beams(const ScanBeams& beams, const BeamGroup& group, BeamIndex& index);

}  // namespace rmap
