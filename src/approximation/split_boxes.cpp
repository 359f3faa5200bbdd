#include "approximation/split_boxes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <queue>

namespace rmap {

namespace {

/// What lies in one slice of a box: how many cells, and the box around them.
struct Slice {
  std::int64_t count = 0;
  CellBox box;

  void add(const Slice& other) {
    if (other.count == 0) return;
    box = count == 0 ? other.box : united(box, other.box);
    count += other.count;
  }
  void add(const Cell& cell) { add(Slice{.count = 1, .box = box_of(cell)}); }
  bool full() const { return static_cast<double>(count) == box.volume(); }
};

/// A place to cut, and how good it is.
struct Cut {
  int axis = -1;
  std::int32_t at = 0;    ///< first place of the upper part
  double volume = 0;      ///< of both parts
  std::int64_t full = 0;  ///< volume of the larger part that is full
  double balance = 0;     ///< volume of the smaller part
  bool reduces = false;   ///< the volume of the box

  /// Less volume first; of those that save none, the one that peels off most, then the evenest.
  bool better_than(const Cut& other) const {
    if (volume != other.volume) return volume < other.volume;
    if (!reduces && full != other.full) return full > other.full;
    return balance > other.balance;
  }
};

struct Node {
  CellBox box;
  std::int64_t count = 0;
  std::int64_t leaves = 1;  ///< boxes in which it ends if it is not joined
  double leaf_volume = 0;   ///< their volume
  std::uint32_t parent = 0;
  std::array<std::uint32_t, 2> children{};  ///< 0: none, since 0 is the root

  bool leaf() const { return children[0] == 0; }
};

class SplitTree {
 public:
  explicit SplitTree(std::vector<Cell> cells) : cells_(std::move(cells)) { build(cells_, 0); }

  void join(double max_false);
  std::vector<CellBox> boxes() const;

 private:
  std::uint32_t build(std::span<Cell> cells, std::uint32_t parent);
  void read_slices(std::span<const Cell> cells, const CellBox& box, int axis);
  Cut best_cut(std::span<const Cell> cells, const Slice& all);
  void summarise(std::uint32_t node);
  /// Makes a leaf of a node and of all below, which are part of the tree no more.
  void forget_below(std::uint32_t node);
  /// Empty volume that joining a node adds, for each box that it saves.
  double price(const Node& node) const {
    return (node.box.volume() - node.leaf_volume) / static_cast<double>(node.leaves - 1);
  }

  std::vector<Cell> cells_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> places_;  // of slices on the axis
  std::vector<Slice> slices_;
  std::vector<Slice> above_;
};

// One for each place on the axis, or where these are more than cells for each that has some.
void SplitTree::read_slices(std::span<const Cell> cells, const CellBox& box, int axis) {
  const std::int32_t low = box.min[axis];
  const std::int64_t length = box.extent()[axis];
  const bool dense = length <= static_cast<std::int64_t>(cells.size());
  if (dense) {
    places_.resize(static_cast<std::size_t>(length));
    std::iota(places_.begin(), places_.end(), low);
  } else {
    places_.clear();
    for (const Cell& cell : cells) places_.push_back(cell[axis]);
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  }
  slices_.assign(places_.size(), {});
  for (const Cell& cell : cells) {
    const auto place =
        dense ? cell[axis] - low
              : std::lower_bound(places_.begin(), places_.end(), cell[axis]) - places_.begin();
    slices_[static_cast<std::size_t>(place)].add(cell);
  }
}

Cut SplitTree::best_cut(std::span<const Cell> cells, const Slice& all) {
  const double whole = all.box.volume();
  Cut best;
  for (int axis = 0; axis < 3; ++axis) {
    if (all.box.extent()[axis] == 1) continue;
    read_slices(cells, all.box, axis);
    const std::size_t length = slices_.size();
    above_.assign(length + 1, {});
    for (std::size_t i = length; i-- > 0;) {
      above_[i] = above_[i + 1];
      above_[i].add(slices_[i]);
    }
    Slice below;
    for (std::size_t i = 1; i < length; ++i) {
      below.add(slices_[i - 1]);
      const Slice& rest = above_[i];
      Cut cut{.axis = axis, .at = places_[i - 1] + 1};
      cut.volume = below.box.volume() + rest.box.volume();
      cut.reduces = cut.volume < whole;
      cut.full = std::max(below.full() ? below.count : 0, rest.full() ? rest.count : 0);
      cut.balance = std::min(below.box.volume(), rest.box.volume());
      if (best.axis < 0 || cut.better_than(best)) best = cut;
    }
  }
  return best;
}

std::uint32_t SplitTree::build(std::span<Cell> cells, std::uint32_t parent) {
  Slice all;
  for (const Cell& cell : cells) all.add(cell);
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({.box = all.box, .count = all.count, .parent = parent});
  if (!all.full()) {
    const Cut cut = best_cut(cells, all);
    const auto upper = std::partition(cells.begin(), cells.end(),
                                      [&](const Cell& cell) { return cell[cut.axis] < cut.at; });
    const auto lower_count = static_cast<std::size_t>(upper - cells.begin());
    const std::uint32_t lower_child = build(cells.first(lower_count), node);
    const std::uint32_t upper_child = build(cells.subspan(lower_count), node);
    nodes_[node].children = {lower_child, upper_child};
  }
  summarise(node);
  return node;
}

void SplitTree::summarise(std::uint32_t index) {
  Node& node = nodes_[index];
  if (node.leaf()) {
    node.leaves = 1;
    node.leaf_volume = node.box.volume();
    return;
  }
  const Node& lower = nodes_[node.children[0]];
  const Node& upper = nodes_[node.children[1]];
  node.leaves = lower.leaves + upper.leaves;
  node.leaf_volume = lower.leaf_volume + upper.leaf_volume;
}

// The cheapest node first. Joining one changes what is left to save above it, so that prices of
// its ancestors are asked anew when their turn comes.
void SplitTree::join(double max_false) {
  using Priced = std::pair<double, std::uint32_t>;
  std::priority_queue<Priced, std::vector<Priced>, std::greater<>> queue;
  for (std::uint32_t node = 0; node < nodes_.size(); ++node) {
    if (!nodes_[node].leaf()) queue.emplace(price(nodes_[node]), node);
  }
  const auto count = static_cast<double>(nodes_[0].count);
  while (!queue.empty()) {
    const auto [asked, index] = queue.top();
    queue.pop();
    Node& node = nodes_[index];
    if (node.leaf() || node.leaves == 1) continue;
    if (const double now = price(node); now > asked) {
      queue.emplace(now, index);
      continue;
    }
    const double added = node.box.volume() - node.leaf_volume;
    const double volume = nodes_[0].leaf_volume + added;
    if (volume - count > max_false * volume) continue;
    const std::int64_t saved = node.leaves - 1;
    forget_below(index);
    for (std::uint32_t at = index;; at = nodes_[at].parent) {
      nodes_[at].leaves -= saved;
      nodes_[at].leaf_volume += added;
      if (at == 0) break;
    }
  }
}

void SplitTree::forget_below(std::uint32_t node) {
  std::vector<std::uint32_t> left{node};
  while (!left.empty()) {
    Node& at = nodes_[left.back()];
    left.pop_back();
    if (!at.leaf()) left.insert(left.end(), at.children.begin(), at.children.end());
    at.children = {};
  }
}

std::vector<CellBox> SplitTree::boxes() const {
  std::vector<CellBox> boxes;
  std::vector<std::uint32_t> left{0};
  while (!left.empty()) {
    const Node& node = nodes_[left.back()];
    left.pop_back();
    if (node.leaf()) {
      boxes.push_back(node.box);
    } else {
      left.insert(left.end(), node.children.rbegin(), node.children.rend());
    }
  }
  return boxes;
}

}  // namespace

std::vector<CellBox> split_boxes(std::span<const CountedCell> cells, double max_false) {
  if (cells.empty()) return {};
  std::vector<Cell> places;
  places.reserve(cells.size());
  for (const CountedCell& counted : cells) places.push_back(counted.cell);
  SplitTree tree(std::move(places));
  tree.join(max_false);
  return tree.boxes();
}

}  // namespace rmap
