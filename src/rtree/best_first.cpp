#include "rtree/node_tests.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory_resource>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/lattice.hpp>
#include <rmap/rtree/box_tree.hpp>

namespace rmap {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool corner_less(const Cell& a, const Cell& b) {
  return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

/// What waits for its turn: a node of `level`, or, with level -1, an item.
struct Candidate {
  double key;
  int level;
  std::uint32_t node;
  int branch;
};

/// Nodes come before items of the same key, and items of the same key by their boxes: so the
/// order of the items does not depend on the shape of the tree.
struct ComesLater {
  const NodePool& leaves;

  bool operator()(const Candidate& a, const Candidate& b) const {
    if (a.key != b.key) return a.key > b.key;
    if (a.level >= 0 || b.level >= 0) return a.level < b.level;
    const CellBox first = leaves.box(a.node, a.branch);
    const CellBox second = leaves.box(b.node, b.branch);
    return first.min == second.min ? corner_less(second.max, first.max)
                                   : corner_less(second.min, first.min);
  }
};

/// The candidates seen so far as a heap, the next one in front; the usual number of them fits
/// on the stack.
class Frontier {
 public:
  explicit Frontier(const BoxTree& tree) : later_{tree.nodes(0)}, candidates_(&memory_) {
    candidates_.reserve(kUsual);
  }

  bool empty() const { return candidates_.empty(); }
  void push(const Candidate& candidate) {
    candidates_.push_back(candidate);
    std::push_heap(candidates_.begin(), candidates_.end(), later_);
  }
  Candidate pop() {
    std::pop_heap(candidates_.begin(), candidates_.end(), later_);
    const Candidate first = candidates_.back();
    candidates_.pop_back();
    return first;
  }

 private:
  static constexpr std::size_t kUsual = 256;

  ComesLater later_;
  alignas(Candidate) std::array<std::byte, kUsual * sizeof(Candidate)> buffer_;
  std::pmr::monotonic_buffer_resource memory_{buffer_.data(), buffer_.size()};
  std::pmr::vector<Candidate> candidates_;
};

/// Visits items in the order of their keys. measure(columns, keys) gives the keys of a node's
/// branches and the mask of those that come into question; a branch's key is never below its
/// MBRC's. visit(box, place, key) returns the key from which on nothing is wanted.
template <class Measure, class Visit>
void best_first(const BoxTree& tree, const Measure& measure, const Visit& visit) {
  if (tree.height() == 0) return;
  double limit = kInfinity;
  Frontier frontier(tree);
  const auto expand = [&](std::uint32_t node, int level) {
    node_tests::Measures keys;
    const NodePool& pool = tree.nodes(level);
    for (std::uint64_t mask = measure(pool.columns(node), keys); mask != 0; mask &= mask - 1) {
      const int branch = std::countr_zero(mask);
      const double key = keys[static_cast<std::size_t>(branch)];
      if (!(key < limit)) continue;
      if (level == 0) {
        frontier.push({key, -1, node, branch});
      } else {
        frontier.push({key, level - 1, pool.child(node, branch), 0});
      }
    }
  };
  expand(tree.root(), tree.height() - 1);
  while (!frontier.empty()) {
    const Candidate next = frontier.pop();
    if (!(next.key < limit)) return;
    if (next.level >= 0) {
      expand(next.node, next.level);
    } else {
      const CellBox box = tree.nodes(0).box(next.node, next.branch);
      limit = std::min(limit, visit(box, BoxTree::Place{next.node, next.branch}, next.key));
    }
  }
}

}  // namespace

void BoxTree::crossed_in_order(const Beam& beam, VisitInOrder visit) const {
  best_first(
      *this,
      [&](const BranchColumns& columns, node_tests::Measures& keys) {
        return node_tests::crossed(columns, beam, keys);
      },
      visit);
}

void BoxTree::nearest(const Vector3d& point, std::size_t k, VisitNearest visit) const {
  if (!cell_at(point)) {
    throw Error(ErrorKind::limit,
                fmt::format("the point ({}, {}, {}) is beyond the limits: in cell units its "
                            "coordinates must lie within {} to {}",
                            point.x(), point.y(), point.z(), kMinCellIndex, kMaxCellIndex));
  }
  if (k == 0) return;
  std::size_t found = 0;
  best_first(
      *this,
      [&](const BranchColumns& columns, node_tests::Measures& keys) {
        node_tests::squared_distances(columns, point, keys);
        return node_tests::all(columns);
      },
      [&](const CellBox& box, Place place, double squared) {
        visit(box, place, std::sqrt(squared));
        return ++found < k ? kInfinity : -kInfinity;
      });
}

}  // namespace rmap
