#pragma once

#include "approximation/block_walk.hpp"
#include "grid/cell_places.hpp"

#include <cstdint>
#include <vector>

#include <rmap/block.hpp>
#include <rmap/cell.hpp>

namespace rmap {

/// A sparse set of cells, by blocks, that changes.
class BlockMasks {
  auto origin_of() const {
    return [this](std::uint32_t i) -> const Cell& { return origins_[i]; };
  }

 public:
  void set(const Cell& cell, bool member) {
    CellMask& mask = mask_at(block_origin(cell));
    const BlockPosition position = block_position(cell);
    if (mask.test(position) == member) return;
    if (member) {
      mask.set(position);
      ++size_;
    } else {
      mask.reset(position);
      --size_;
    }
  }
  void add(const CellBox& box) {
    for_each_block_of(box, [&](const Cell& origin) {
      CellMask& mask = mask_at(origin);
      size_ -= mask.count();
      mask |= positions_in(origin, box);
      size_ += mask.count();
      return true;
    });
  }

  std::int64_t size() const { return size_; }
  bool contains(const Cell& cell) const {
    const CellMask* mask = find(block_origin(cell));
    return mask != nullptr && mask->test(block_position(cell));
  }
  /// Number of places in a box that are not in the set.
  std::int64_t missing(const CellBox& box) const {
    std::int64_t missing = box.extent().prod();
    for_each_block_of(box, [&](const Cell& origin) {
      if (const CellMask* mask = find(origin)) {
        missing -= (*mask & positions_in(origin, box)).count();
      }
      return true;
    });
    return missing;
  }
  /// use(origin, cells) for each block, which may have none.
  template <class Use>
  void for_each_block(const Use& use) const {
    for (std::size_t i = 0; i < origins_.size(); ++i) use(origins_[i], masks_[i]);
  }
  /// use(cell) for each cell in a box.
  template <class Use>
  void for_each(const CellBox& box, const Use& use) const {
    for_each_block_of(box, [&](const Cell& origin) {
      if (const CellMask* mask = find(origin)) {
        (*mask & positions_in(origin, box)).for_each([&](BlockPosition position) {
          use(Cell(origin + block_offset(position)));
        });
      }
      return true;
    });
  }

 private:
  const CellMask* find(const Cell& origin) const {
    const auto place = places_.find(origin, origin_of());
    return place ? &masks_[*place] : nullptr;
  }
  CellMask& mask_at(const Cell& origin) {
    const std::uint32_t place = places_.add(origin, CellPlaces::hash_of(origin), origin_of());
    if (place == origins_.size()) {
      origins_.push_back(origin);
      masks_.emplace_back();
    }
    return masks_[place];
  }

  CellPlaces places_;
  std::vector<Cell> origins_;
  std::vector<CellMask> masks_;
  std::int64_t size_ = 0;
};

}  // namespace rmap
