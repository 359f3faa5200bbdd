#pragma once

#include "approximation/bit_grid.hpp"
#include "approximation/cover_limits.hpp"

#include <span>

#include <rmap/cell.hpp>

namespace rmap {

/// A region of a sparse set of cells with a bit for each place, and room around for boxes that
/// reach beyond: where dense algorithms work, with the region's own cells from 0 on.
class DenseRegion {
 public:
  /// Allowed are `cells`, which lie in `region`, and all that are at most limits.outer from them,
  /// within the limits of indices.
  DenseRegion(std::span<const Cell> cells, const CellBox& region, const CoverLimits& limits);

  const BitGrid& allowed() const { return allowed_; }
  /// An empty set of the same size.
  BitGrid none() const { return BitGrid(allowed_.size()); }
  /// Every place that may be in a set.
  CellBox places() const { return {Cell::Ones(), allowed_.size() - Cell::Ones()}; }

  Cell to_local(const Cell& cell) const { return cell - origin_; }
  CellBox to_local(const CellBox& box) const { return {box.min - origin_, box.max - origin_}; }
  CellBox to_map(const CellBox& box) const { return {box.min + origin_, box.max + origin_}; }

 private:
  void forbid_beyond_limits();

  Cell origin_;
  BitGrid allowed_;
};

}  // namespace rmap
