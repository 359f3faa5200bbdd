#pragma once

#include "approximation/cell_blocks.hpp"
#include "grid/cell_places.hpp"

#include <cstdint>
#include <vector>

#include <rmap/block.hpp>
#include <rmap/cell.hpp>

namespace rmap {

/// The union of boxes, by blocks of 8 x 8 x 8 cells.
class BoxUnion {
  auto origin_of() const {
    return [this](std::uint32_t i) -> const Cell& { return origins_[i]; };
  }

 public:
  /// Number of places in a box that are not in the union.
  std::int64_t missing(const CellBox& box) const {
    std::int64_t missing = box.extent().prod();
    for_each_block_of(box, [&](const Cell& origin, const CellMask& inside) {
      const auto place = places_.find(origin, origin_of());
      if (place) missing -= (masks_[*place] & inside).count();
    });
    return missing;
  }
  void add(const CellBox& box) {
    for_each_block_of(box, [&](const Cell& origin, const CellMask& inside) {
      const std::uint32_t place = places_.add(origin, CellPlaces::hash_of(origin), origin_of());
      if (place == origins_.size()) {
        origins_.push_back(origin);
        masks_.emplace_back();
      }
      volume_ -= masks_[place].count();
      masks_[place] |= inside;
      volume_ += masks_[place].count();
    });
  }
  std::int64_t volume() const { return volume_; }
  bool contains(const Cell& cell) const {
    const auto place = places_.find(block_origin(cell), origin_of());
    return place && masks_[*place].test(block_position(cell));
  }
  /// use(origin, cells) for each block with cells in the union.
  template <class Use>
  void for_each_block(const Use& use) const {
    for (std::size_t i = 0; i < origins_.size(); ++i) use(origins_[i], masks_[i]);
  }

 private:
  template <class Use>
  static void for_each_block_of(const CellBox& box, const Use& use) {
    const Cell first = block_origin(box.min);
    Cell at = first;
    for (at.z() = first.z(); at.z() < box.max.z(); at.z() += kBlockEdge) {
      for (at.y() = first.y(); at.y() < box.max.y(); at.y() += kBlockEdge) {
        for (at.x() = first.x(); at.x() < box.max.x(); at.x() += kBlockEdge) {
          use(at, positions_in(at, box));
        }
      }
    }
  }

  CellPlaces places_;
  std::vector<Cell> origins_;
  std::vector<CellMask> masks_;
  std::int64_t volume_ = 0;
};

}  // namespace rmap
