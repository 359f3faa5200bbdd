#pragma once

#include "approximation/bit_grid.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/function_ref.hpp>

namespace rmap {

/// Finds boxes inside a set of cells that no larger one inside it holds.
class MaximalBoxes {
 public:
  /// `allowed` must live as long.
  explicit MaximalBoxes(const BitGrid& allowed) : allowed_(allowed) {}

  /// visit(box) for boxes that hold `core`, a box inside the set, and grow no further on two
  /// axes: among them, unless there are very many, each one that is maximal.
  void for_each(const CellBox& core, FunctionRef<void(const CellBox&)> visit);
  /// `box`, grown along x, y, and z as far as it goes.
  CellBox grown(CellBox box) const;

 private:
  struct Layer {
    std::vector<Run> up;    // [i]: what rows 0 to i above the core have in common
    std::vector<Run> down;  // [i]: the same below; both begin with the core's own rows

    void intersect(const Layer& other);
    bool within(const Layer& other) const;
  };
  struct Axes {
    int along, mid, out;
  };

  Axes axes_of(const CellBox& core) const;
  bool read_layer(const CellBox& core, const Axes& axes, std::int32_t at, Layer& layer) const;
  void visit_window(const CellBox& core, const Axes& axes, const Layer& layer, CellBox box,
                    FunctionRef<void(const CellBox&)> visit) const;
  void visit_windows_above(const CellBox& core, const Axes& axes, std::int32_t lowest,
                           FunctionRef<void(const CellBox&)> visit);

  const BitGrid& allowed_;
  // Kept for their memory: layers at and beside the core, and windows of them.
  std::vector<Layer> above_, below_;
  std::size_t above_count_ = 0, below_count_ = 0;
  Layer bottom_, window_;
};

}  // namespace rmap
