#pragma once

#include "approximation/bit_grid.hpp"
#include "approximation/row_numbers.hpp"

#include <cstdint>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// The stars of cells: the star of a cell is every cell with which it fits into one box of
/// allowed cells, itself among them. Being in the star of one another is mutual.
class Stars {
 public:
  /// `cells`: those that stars are made of, a subset of `allowed`, in rows along x; numbered along
  /// the rows. Both must live as long.
  Stars(const BitGrid& allowed, const BitRows& cells);

  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(places_.size()); }
  /// Place of a cell in the grid.
  const Cell& place(std::uint32_t cell) const { return places_[cell]; }
  /// use(first, count) for runs of numbers of the cells in the star of a cell. Not thread-safe.
  template <class Use>
  void for_each(std::uint32_t cell, const Use& use);

 private:
  struct Layer {
    Run column;           // row of the cell's y
    std::vector<Run> up;  // rows beyond, as long as something is in reach
    std::vector<Run> down;
  };

  // What the layer of the cell itself leaves.
  void begin(const Cell& cell, Layer& layer) const;
  // Narrows what one layer leaves to what the next one does as well; false when nothing is left.
  bool step(const Cell& cell, std::int32_t z, Layer& layer) const;
  template <class Use>
  void use_layer(const Cell& cell, std::int32_t z, const Layer& layer, const Use& use) const;

  const BitGrid& allowed_;
  const BitRows& cells_;
  RowNumbers numbers_;
  std::vector<Cell> places_;
  Layer middle_, layer_;
};

template <class Use>
void Stars::use_layer(const Cell& cell, std::int32_t z, const Layer& layer, const Use& use) const {
  const auto use_row = [&](std::int32_t y, const Run& run) {
    numbers_.for_each_range(cells_, {0, y, z}, run,
                            [&](std::uint32_t first, std::uint32_t count, std::ptrdiff_t,
                                BitRows::Word) { use(first, count); });
  };
  use_row(cell.y(), layer.column);
  for (std::size_t i = 0; i < layer.up.size(); ++i) {
    use_row(cell.y() + 1 + static_cast<std::int32_t>(i), layer.up[i]);
  }
  for (std::size_t i = 0; i < layer.down.size(); ++i) {
    use_row(cell.y() - 1 - static_cast<std::int32_t>(i), layer.down[i]);
  }
}

template <class Use>
void Stars::for_each(std::uint32_t number, const Use& use) {
  const Cell& cell = places_[number];
  begin(cell, middle_);
  use_layer(cell, cell.z(), middle_, use);
  for (const int direction : {1, -1}) {
    layer_ = middle_;
    for (std::int32_t z = cell.z() + direction; step(cell, z, layer_); z += direction) {
      use_layer(cell, z, layer_, use);
    }
  }
}

}  // namespace rmap
