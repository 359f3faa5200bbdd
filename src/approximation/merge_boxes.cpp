#include "approximation/merge_boxes.hpp"

#include "approximation/block_masks.hpp"
#include "approximation/box_buckets.hpp"
#include "approximation/cell_boxes.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>

namespace rmap {

namespace {

struct Pair {
  std::int64_t cost;    ///< places that joining the two adds to the union, at most
  std::int64_t volume;  ///< of their common box: of equal costs the smaller one first
  std::uint32_t a, b;

  friend bool operator>(const Pair& x, const Pair& y) {
    return std::tie(x.cost, x.volume, x.a, x.b) > std::tie(y.cost, y.volume, y.a, y.b);
  }
};

class Merge {
 public:
  Merge(const CellBlocks& cells, std::span<const CellBox> boxes, const CellBlocks* allowed)
      : cells_(static_cast<std::int64_t>(cells.size())), allowed_(allowed) {
    for (const CellBox& box : boxes) add(box);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) look_around(i, true);
  }

  void run(double max_false);
  std::vector<CellBox> boxes() const;

 private:
  void add(const CellBox& box);
  void drop(std::uint32_t box);
  void look_around(std::uint32_t box, bool only_later);
  bool alive(std::uint32_t box) const { return !boxes_[box].empty(); }

  std::int64_t cells_;
  const CellBlocks* allowed_;
  std::vector<CellBox> boxes_;  // those that were joined or dropped are empty
  BoxBuckets buckets_;
  BlockMasks union_;
  std::priority_queue<Pair, std::vector<Pair>, std::greater<>> pairs_;
  std::vector<std::uint32_t> near_;
  std::vector<Pair> partners_;
};

void Merge::add(const CellBox& box) {
  const auto number = static_cast<std::uint32_t>(boxes_.size());
  boxes_.push_back(box);
  buckets_.add(number, box);
  union_.add(box);
}

void Merge::drop(std::uint32_t box) {
  buckets_.remove(box, boxes_[box]);
  boxes_[box] = {};
}

// The best partners of a box among those that touch it or lie a cell away.
void Merge::look_around(std::uint32_t box, bool only_later) {
  constexpr std::size_t kPartners = 6;  // twice as many: 0.4 % fewer boxes, half as long again
  constexpr int kReach = 2;             // a gap of one cell, and a cell beyond it
  const CellBox around = grown_by(boxes_[box], kReach);
  near_.clear();
  buckets_.for_each_near(around, [&](std::uint32_t other) {
    if (other != box && (!only_later || other > box) && boxes_[other].overlaps(around)) {
      near_.push_back(other);
    }
  });
  std::sort(near_.begin(), near_.end());
  near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
  partners_.clear();
  for (const std::uint32_t other : near_) {
    const CellBox both = united(boxes_[box], boxes_[other]);
    // What it would add if no other box held a part of it.
    const std::int64_t most =
        volume_of(both) - volume_of(boxes_[box]) - volume_of(boxes_[other]) +
        (boxes_[box].overlaps(boxes_[other]) ? volume_of(intersection(boxes_[box], boxes_[other]))
                                             : 0);
    partners_.push_back({most, volume_of(both), std::min(box, other), std::max(box, other)});
  }
  const auto order = [](const Pair& x, const Pair& y) { return y > x; };
  if (partners_.size() > kPartners) {
    std::nth_element(partners_.begin(), partners_.begin() + kPartners, partners_.end(), order);
    partners_.resize(kPartners);
  }
  for (Pair& pair : partners_) {
    const CellBox both = united(boxes_[pair.a], boxes_[pair.b]);
    if (allowed_ != nullptr && !allowed_->holds(both)) continue;
    pair.cost = union_.missing(both);
    pairs_.push(pair);
  }
}

// The union only grows, so a pair costs at most what it did when it was looked at.
void Merge::run(double max_false) {
  while (!pairs_.empty()) {
    const Pair pair = pairs_.top();
    pairs_.pop();
    if (!alive(pair.a) || !alive(pair.b)) continue;
    const CellBox both = united(boxes_[pair.a], boxes_[pair.b]);
    const std::int64_t volume = union_.size() + union_.missing(both);
    if (static_cast<double>(volume - cells_) > max_false * static_cast<double>(volume)) continue;
    near_.clear();
    buckets_.for_each_near(both, [&](std::uint32_t other) {
      if (both.contains(boxes_[other])) near_.push_back(other);
    });
    std::sort(near_.begin(), near_.end());
    near_.erase(std::unique(near_.begin(), near_.end()), near_.end());
    for (const std::uint32_t other : near_) drop(other);
    add(both);
    look_around(static_cast<std::uint32_t>(boxes_.size() - 1), false);
  }
}

std::vector<CellBox> Merge::boxes() const {
  std::vector<CellBox> boxes;
  std::copy_if(boxes_.begin(), boxes_.end(), std::back_inserter(boxes),
               [](const CellBox& box) { return !box.empty(); });
  return boxes;
}

}  // namespace

std::vector<CellBox> merge_boxes(const CellBlocks& cells, std::span<const CellBox> boxes,
                                 double max_false, const CellBlocks* allowed) {
  Merge merge(cells, boxes, allowed);
  merge.run(max_false);
  return merge.boxes();
}

}  // namespace rmap
