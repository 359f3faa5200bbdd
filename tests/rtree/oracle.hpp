#pragma once

#include "rtree/boxes.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <rmap/rtree.hpp>

namespace rmap::test {

using Tree = RTree<int>;
using Items = std::vector<Tree::Item>;

inline auto key_of(const CellBox& box) {
  return std::make_tuple(box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y(),
                         box.max.z());
}

/// Boxes with their payloads in an order of their own, to compare what was found with.
class Found {
 public:
  void add(const CellBox& box, int payload) { found_.emplace_back(key_of(box), payload); }
  std::size_t size() const { return found_.size(); }
  friend bool operator==(Found a, Found b) {
    std::sort(a.found_.begin(), a.found_.end());
    std::sort(b.found_.begin(), b.found_.end());
    return a.found_ == b.found_;
  }

 private:
  std::vector<std::pair<decltype(key_of(CellBox{})), int>> found_;
};

/// A visitor that notes all it is shown.
inline auto into(Found& found) {
  return [&found](const CellBox& box, int payload) { found.add(box, payload); };
}

/// The items that `wanted` accepts, one by one: what every search must equal.
template <class Wanted>
Found plain_search(const Items& items, const Wanted& wanted) {
  Found found;
  for (const auto& [box, payload] : items) {
    if (wanted(box)) found.add(box, payload);
  }
  return found;
}

/// Items with a key, in the order that crossed_in_order and nearest_k promise.
struct Ranked {
  double key;
  CellBox box;
};
template <class Key>
std::vector<Ranked> plain_ranking(const Items& items, const Key& key) {
  std::vector<Ranked> ranked;
  for (const auto& item : items) {
    if (const std::optional<double> value = key(item.box)) ranked.push_back({*value, item.box});
  }
  std::sort(ranked.begin(), ranked.end(), [](const Ranked& a, const Ranked& b) {
    return std::make_tuple(a.key, key_of(a.box)) < std::make_tuple(b.key, key_of(b.box));
  });
  return ranked;
}

inline std::optional<double> entry(const Beam& beam, const CellBox& box) {
  const auto part = crossing(beam, box);
  return part ? std::optional(part->enter) : std::nullopt;
}

inline double squared_distance(const Vector3d& point, const CellBox& box) {
  double squared[3];
  for (int axis = 0; axis < 3; ++axis) {
    double outside = 0;
    if (point[axis] < box.min[axis]) outside = box.min[axis] - point[axis];
    if (point[axis] > box.max[axis]) outside = point[axis] - box.max[axis];
    squared[axis] = outside * outside;
  }
  return (squared[0] + squared[1]) + squared[2];
}

}  // namespace rmap::test
