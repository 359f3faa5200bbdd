#pragma once

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
  void add(const PointTile& tile);
  void add(const NearestEnds& other);
  /// Numbers of the beams kept, ascending.
  std::vector<std::uint32_t> numbers() const;

 private:
  struct Entry {
    Cell cell;
    std::uint32_t number;
    double distance;  ///< squared, from the cell's centre
  };

  void add(const Entry& entry);
  bool is_nearer(const Entry& a, const Entry& b) const;
  std::size_t slot_of(const Cell& cell) const;
  void grow();

  const ScanBeams* beams_;
  std::vector<Entry> entries_;
  std::vector<std::uint32_t> slots_;  ///< 1 + place in entries_, 0 when free: open addressing
  std::size_t last_ = 0;
};

}  // namespace rmap
