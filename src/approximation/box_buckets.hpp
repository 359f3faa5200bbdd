#pragma once

#include "approximation/block_walk.hpp"
#include "grid/cell_places.hpp"

#include <cstdint>
#include <vector>

#include <rmap/block.hpp>
#include <rmap/cell.hpp>

namespace rmap {

/// Finds boxes near a box: each stands in every bucket of 8 x 8 x 8 cells that it touches.
class BoxBuckets {
  auto cell_of() const {
    return [this](std::uint32_t i) -> const Cell& { return origins_[i]; };
  }

 public:
  void add(std::uint32_t number, const CellBox& box) {
    for_each_block_of(box, [&](const Cell& origin) {
      buckets_[bucket(origin)].push_back(number);
      return true;
    });
  }
  void remove(std::uint32_t number, const CellBox& box) {
    for_each_block_of(box, [&](const Cell& origin) {
      std::erase(buckets_[bucket(origin)], number);
      return true;
    });
  }
  /// use(number) for each box in a bucket that `region` touches: once for each such bucket.
  template <class Use>
  void for_each_near(const CellBox& region, const Use& use) const {
    for_each_block_of(region, [&](const Cell& origin) {
      if (const auto place = places_.find(origin, cell_of())) {
        for (const std::uint32_t number : buckets_[*place]) use(number);
      }
      return true;
    });
  }

 private:
  std::uint32_t bucket(const Cell& origin) {
    const std::uint32_t place = places_.add(origin, CellPlaces::hash_of(origin), cell_of());
    if (place == origins_.size()) {
      origins_.push_back(origin);
      buckets_.emplace_back();
    }
    return place;
  }
  CellPlaces places_;
  std::vector<Cell> origins_;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace rmap
