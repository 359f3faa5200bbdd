#pragma once

#include "grid/beam_groups.hpp"
#include "grid/inverse/beam_index.hpp"
#include "grid/leaf_marks.hpp"
#include "grid/scan_beams.hpp"

#include <span>
#include <vector>

#include <rmap/value.hpp>

namespace rmap {

/// Whether the beams of a group are cast inversely, or followed one by one.
bool casts_inversely(const BeamGroup& group, const Options& options);

/// Finds the existing cells that the beams of a scan cross, but for those that they
/// hit and, it may be, those that a miss cannot change; each leaf once.
class MissedCells {
 public:
  /// Keeps references to everything.
  MissedCells(const LeafStore& store, const UpdateRule& rule, const ScanBeams& beams,
              const LeafMarks& hit);

  /// Of some of the beams, each group by the traversal that suits it.
  std::vector<MarkedLeaf> of(std::span<const BeamGroup> groups) const;
  /// Of beams that are in an index already, which gets sorted.
  std::vector<MarkedLeaf> of(BeamIndex& index) const;

 private:
  int threads() const { return beams_.options().threads; }

  const LeafStore& store_;
  const UpdateRule& rule_;
  const ScanBeams& beams_;
  const LeafMarks& hit_;
};

}  // namespace rmap
