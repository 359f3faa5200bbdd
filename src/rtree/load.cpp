#include "rtree/packing.hpp"

#include <limits>
#include <numeric>
#include <utility>

#include <rmap/error.hpp>
#include <rmap/rtree/box_tree.hpp>

namespace rmap {

void BoxTree::load(std::span<const CellBox> boxes,
                   FunctionRef<const std::byte*(std::size_t)> payload_of, Packing packing) {
  if (boxes.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw Error(ErrorKind::limit, "the R-tree cannot be packed: it holds at most 4294967295 items");
  }
  for (std::size_t i = 0; i < boxes.size(); ++i) check_box(boxes[i], i);
  BoxTree packed(options_, leaves_.content_size(), leaves_.content_alignment());
  if (!boxes.empty()) packed.build(boxes, payload_of, packing);
  *this = std::move(packed);
}

/// Fills an empty tree level by level, from the leaves to the root.
void BoxTree::build(std::span<const CellBox> boxes,
                    FunctionRef<const std::byte*(std::size_t)> payload_of, Packing packing) {
  const auto max = static_cast<std::size_t>(options_.max_branches);
  const auto min = static_cast<std::size_t>(options_.min_branches);
  std::vector<CellBox> below(boxes.begin(), boxes.end());
  std::vector<std::uint32_t> children;
  size_ = boxes.size();
  for (height_ = 0; height_ == 0 || children.size() > 1; ++height_) {
    std::vector<std::uint32_t> order;
    if (height_ == 0 || packing == Packing::sort_tile_recursive) {
      order = packed_order(below, max, packing);
    } else {
      // The nodes of a Hilbert packing follow the curve already.
      order.resize(below.size());
      std::iota(order.begin(), order.end(), 0u);
    }
    NodePool& level = pool(height_);
    std::vector<CellBox> bounds;
    std::vector<std::uint32_t> parents;
    for (std::size_t first = 0; first < order.size();) {
      const std::uint32_t node = level.allocate();
      const std::size_t end = first + next_run(order.size() - first, min, max);
      for (; first < end; ++first) {
        const std::uint32_t i = order[first];
        level.append(
            node, below[i],
            height_ == 0 ? payload_of(i) : reinterpret_cast<const std::byte*>(&children[i]));
      }
      bounds.push_back(level.bounds(node));
      parents.push_back(node);
    }
    below = std::move(bounds);
    children = std::move(parents);
  }
  root_ = children.front();
}

void BoxTree::repack(Packing packing) {
  std::vector<CellBox> boxes;
  std::vector<Place> places;
  boxes.reserve(size_);
  places.reserve(size_);
  for_each([&](const CellBox& box, Place place) {
    boxes.push_back(box);
    places.push_back(place);
    return true;
  });
  const BoxTree& tree = *this;
  load(
      boxes, [&](std::size_t i) { return tree.payload(places[i]); }, packing);
}

}  // namespace rmap
