#pragma once

#include <cstdint>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// An aligned block of 8 x 8 x 8 cells in which something changed.
struct ChangedBlock {
  Cell origin;  ///< its lowest cell
  bool exists;  ///< whether it still holds a cell

  friend bool operator==(const ChangedBlock& a, const ChangedBlock& b) {
    return a.origin == b.origin && a.exists == b.exists;
  }
};

/// A cell and whether it is occupied now.
struct CellState {
  Cell cell;
  bool occupied;

  friend bool operator==(const CellState& a, const CellState& b) {
    return a.cell == b.cell && a.occupied == b.occupied;
  }
};

/// What changed in a grid after a revision.
struct Changes {
  std::uint64_t since = 0;
  std::uint64_t revision = 0;  ///< the grid's revision now
  /// Blocks in which a value changed or a cell appeared or went, in Morton order.
  std::vector<ChangedBlock> blocks = {};
  /// Whether `blocks` is all: else the grid no longer knows which blocks went
  /// since; then `blocks` lists every existing one, and what is not in it is gone.
  bool blocks_complete = true;
  /// complete: the cells that flipped between occupied and not (once or more)
  /// since, with what they are now. Else the journal does not reach back that
  /// far (or is off): every existing cell of `blocks`. In Morton order.
  std::vector<CellState> cells = {};
  bool complete = true;
};

}  // namespace rmap
