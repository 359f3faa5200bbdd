#pragma once

#include "approximation/bit_rows.hpp"
#include "approximation/row_numbers.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rmap/block.hpp>
#include <rmap/cell.hpp>

namespace rmap {

/// Which boxes cover which cells, so far as it takes to tell the cells that only one box covers,
/// and which box that is. Boxes are numbers that their owner gives.
class CoverRegistry {
 public:
  /// Of the cells in `required`, in rows along x.
  explicit CoverRegistry(const BitRows& required);

  /// Makes room for boxes with numbers below `boxes`.
  void resize(std::size_t boxes) { sole_.resize(boxes, 0); }

  /// `covered`: the cells that the box covers, within the grid.
  void add(std::uint32_t box, const CellBox& covered);
  /// The same; and appends the boxes that lost their last cell of their own by it.
  void add(std::uint32_t box, const CellBox& covered, std::vector<std::uint32_t>& idle);
  void remove(std::uint32_t box, const CellBox& covered);

  /// Number of cells that only this box covers.
  std::uint32_t sole(std::uint32_t box) const { return sole_[box]; }
  /// The smallest box that holds the cells in `covered` that one box only covers: of the box that
  /// covers them all, those of its own.
  CellBox sole_bounds(std::uint32_t box, const CellBox& covered) const;
  /// How close the other boxes come to being dropped by a box that covers these cells: the sum,
  /// over the cells that one box only covers, of 1 / sole(that box).
  double relief(const CellBox& covered) const;

 private:
  struct Cover {
    std::uint32_t count = 0;
    std::uint32_t boxes = 0;  ///< exclusive or of the boxes' numbers: of one box, its number
  };

  /// use(first, count, cells, origin) for each word of a row with cells in the box: as RowNumbers
  /// has them, and the place of the word.
  template <class Use>
  void for_each_range(const CellBox& covered, const Use& use) const;

  BitRows required_;
  RowNumbers numbers_;
  std::vector<Cover> covers_;        ///< by cell, numbered along the rows
  std::vector<std::uint32_t> sole_;  ///< by box
};

}  // namespace rmap
