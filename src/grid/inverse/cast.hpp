#pragma once

#include "grid/inverse/beam_index.hpp"
#include "grid/leaf_store.hpp"
#include "grid/scan_beams.hpp"

#include <vector>

#include <rmap/value.hpp>

namespace rmap {

/// Inverse beam casting: instead of following the beams through free space, asks
/// each existing cell in view whether one of them crosses it. Finds the cells
/// that the forward traversal does, but for those that the beams hit and those that
/// are settled, which a miss cannot change.
/// Cost: by cells in view that are not settled; neither by the length of the
/// beams nor, beyond the descent, by the size of the map.
class Cast {
 public:
  /// The cells of a leaf that the scan hits, null for none. Each leaf in view comes once,
  /// all that have end cells among them; its values may be changed, its cells not.
  using HitIn = FunctionRef<const CellMask*(std::size_t range, LeafId id, const Leaf& leaf)>;
  /// The cells of a leaf that beams cross, at least one; each leaf at most once, after HitIn.
  using Crossed =
      FunctionRef<void(std::size_t range, LeafId id, const Cell& origin, const CellMask& cells)>;

  /// Keeps references to everything. The index must be sorted.
  Cast(const LeafStore& store, const ScanBeams& beams, const BeamIndex& index,
       const UpdateRule& rule, int threads);

  /// The leaves are divided into ranges, which threads take beside one another; in the order
  /// of ranges they come alike for any number of threads.
  std::size_t ranges() const { return ranges_; }
  void run(HitIn hit_in, Crossed crossed) const;

 private:
  // Whether a beam may cross the box or end there, those without a direction included.
  bool may_enter(const CellBox& box) const;
  CellMask crossed_in(const Cell& block, const CellMask& asked) const;
  void run_by_block(std::size_t range, const LeafStore::Part& part, HitIn hit_in,
                    Crossed crossed) const;
  void run_by_cell(std::size_t range, std::span<const LeafStore::Part> parts, HitIn hit_in,
                   Crossed crossed) const;

  const LeafStore& store_;
  const ScanBeams& beams_;
  const BeamIndex& index_;
  const UpdateRule& rule_;
  std::vector<LeafStore::Part> parts_;
  std::size_t ranges_;
};

}  // namespace rmap
