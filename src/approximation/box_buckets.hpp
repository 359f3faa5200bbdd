#pragma once

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
    for_each_place(box, [&](const Cell& origin) { buckets_[bucket(origin)].push_back(number); });
  }
  void remove(std::uint32_t number, const CellBox& box) {
    for_each_place(box, [&](const Cell& origin) { std::erase(buckets_[bucket(origin)], number); });
  }
  /// use(number) for each box in a bucket that `region` touches: once for each such bucket.
  template <class Use>
  void for_each_near(const CellBox& region, const Use& use) const {
    for_each_place(region, [&](const Cell& origin) {
      const auto place = places_.find(origin, cell_of());
      if (!place) return;
      for (const std::uint32_t number : buckets_[*place]) use(number);
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
  template <class Use>
  static void for_each_place(const CellBox& box, const Use& use) {
    const Cell first = block_origin(box.min);
    Cell at = first;
    for (at.z() = first.z(); at.z() < box.max.z(); at.z() += kBlockEdge) {
      for (at.y() = first.y(); at.y() < box.max.y(); at.y() += kBlockEdge) {
        for (at.x() = first.x(); at.x() < box.max.x(); at.x() += kBlockEdge) use(at);
      }
    }
  }

  CellPlaces places_;
  std::vector<Cell> origins_;
  std::vector<std::vector<std::uint32_t>> buckets_;
};

}  // namespace rmap
