#pragma once

#include <cstddef>
#include <unordered_map>
#include <utility>

#include <rmap/block.hpp>
#include <rmap/cell.hpp>
#include <rmap/lattice.hpp>
#include <rmap/scan.hpp>

namespace rmap::evaluation {

/// A set of cells, as masks of blocks of 8 x 8 x 8.
class CellSet {
 public:
  void insert(const Cell& cell);
  bool contains(const Cell& cell) const;
  std::size_t size() const;

  /// use(cell) for each cell, block by block.
  template <class Use>
  void for_each(Use&& use) const {
    for (const auto& [origin, mask] : blocks_) {
      mask.for_each([&](BlockPosition position) { use(Cell(origin + block_offset(position))); });
    }
  }

 private:
  std::unordered_map<Cell, CellMask, CellHash> blocks_;
  // Cells come in along beams: the next one mostly lies in the block of the last.
  Cell last_origin_ = Cell::Constant(kMaxCellIndex);
  CellMask* last_ = nullptr;
};

/// What one scan says of the cells: in which a beam ended, and which were crossed and not hit.
/// Each cell once, however many beams met it.
struct SeenCells {
  CellSet ends;
  CellSet path;
};

/// By the definition of crossing that the library inserts by (rmap/beam.hpp). The scan is in the
/// map's frame; points beyond the limits of cell indices are passed over.
SeenCells seen_cells(const Scan& scan, const Lattice& lattice);

}  // namespace rmap::evaluation
