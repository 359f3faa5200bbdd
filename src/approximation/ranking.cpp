#include "approximation/ranking.hpp"

#include "approximation/cell_boxes.hpp"

#include <algorithm>
#include <queue>

namespace rmap {

namespace {

/// The cells that no box covers yet.
class Uncovered {
 public:
  Uncovered(const CellBlocks& cells, CuboidWeight weight) : cells_(cells), weight_(weight) {
    left_.reserve(cells.blocks().size());
    for (const CellBlocks::Block& block : cells.blocks()) left_.push_back(block.cells);
  }

  std::uint64_t weight_in(const CellBox& box) const {
    std::uint64_t weight = 0;
    for_each_block(box, [&](const CellBlocks::Block& block, const CellMask& left) {
      if (weight_ == CuboidWeight::cells) {
        weight += left.count();
      } else {
        left.for_each_ranked(block.cells, [&](BlockPosition, std::uint32_t rank) {
          weight += cells_.points(block.first + rank);
        });
      }
    });
    return weight;
  }

  /// The smallest box that holds those in `box`, of which there is one at least.
  CellBox bounds_in(const CellBox& box) const {
    CellBox bounds{.min = box.max, .max = box.min};
    for_each_block(box, [&](const CellBlocks::Block& block, const CellMask& left) {
      left.for_each([&](BlockPosition position) {
        bounds = united(bounds, box_of(block.origin + block_offset(position)));
      });
    });
    return bounds;
  }

  void cover(const CellBox& box) {
    for_each_block(box, [&](const CellBlocks::Block& block, const CellMask& left) {
      CellMask& of_block = left_[place_of(block)];
      of_block = of_block.without(left);
    });
  }

 private:
  std::size_t place_of(const CellBlocks::Block& block) const {
    return static_cast<std::size_t>(&block - cells_.blocks().data());
  }
  template <class Use>
  void for_each_block(const CellBox& box, const Use& use) const {
    cells_.for_each_block(box, [&](const CellBlocks::Block& block, const CellMask& inside) {
      const CellMask left = inside & left_[place_of(block)];
      if (!left.none()) use(block, left);
      return true;
    });
  }

  const CellBlocks& cells_;
  CuboidWeight weight_;
  std::vector<CellMask> left_;  // by block
};

struct Promise {
  std::uint64_t gain;  ///< no less than what the box covers anew
  std::uint32_t box;

  // The greatest gain is on top, of equal ones the box that comes first.
  friend bool operator<(const Promise& a, const Promise& b) {
    return a.gain != b.gain ? a.gain < b.gain : a.box > b.box;
  }
};

}  // namespace

std::vector<RankedBox> ranked(const CellBlocks& cells, std::span<const CellBox> boxes,
                              CuboidWeight weight, int inner) {
  Uncovered uncovered(cells, weight);
  const auto covered = [&](std::uint32_t box) { return grown_by(boxes[box], inner); };
  std::vector<Promise> promises;
  promises.reserve(boxes.size());
  for (std::uint32_t box = 0; box < boxes.size(); ++box) {
    promises.push_back({uncovered.weight_in(covered(box)), box});
  }
  std::priority_queue<Promise> queue(std::less<Promise>(), std::move(promises));
  std::vector<RankedBox> ranked;
  while (!queue.empty()) {
    Promise best = queue.top();
    queue.pop();
    best.gain = uncovered.weight_in(covered(best.box));
    if (best.gain == 0) continue;
    if (!queue.empty() && best < queue.top()) {
      queue.push(best);
      continue;
    }
    const CellBox& box = boxes[best.box];
    ranked.push_back({inner == 0 ? uncovered.bounds_in(box) : box, best.gain});
    uncovered.cover(covered(best.box));
  }
  return ranked;
}

}  // namespace rmap
