#pragma once

#include "grid/block_kernel.hpp"
#include "grid/cell_places.hpp"
#include "grid/point_tile.hpp"
#include "grid/scan_beams.hpp"

#include <cstdint>
#include <vector>

namespace rmap {

/// Of the beams that share an end cell keeps the one whose end is nearest to the
/// cell's centre (ties: smallest end, then smallest origin, by x, y, z): the
/// option `beams = per_end_cell`.
class NearestEnds {
 public:
  explicit NearestEnds(const ScanBeams& beams);

  /// Takes the points of a tile that end in a cell.
  void add(const PointTile& tile, const EndBlocks& blocks);
  void add(const NearestEnds& other);
  /// Numbers of the beams kept, ascending.
  std::vector<std::uint32_t> numbers() const;

 private:
  struct Entry {
    Cell cell;
    std::uint32_t hash;
    std::uint32_t number;
    double distance;  ///< squared, from the cell's centre
  };

  void add(const Entry& entry);
  bool is_nearer(const Entry& a, const Entry& b) const;

  const ScanBeams* beams_;
  CellPlaces places_;
  std::vector<Entry> entries_;
};

}  // namespace rmap
