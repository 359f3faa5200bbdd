#include "rtree/node_tests.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>

#include <rmap/rtree/box_tree.hpp>

namespace rmap {

namespace {

/// Visits the items below `node` that select(columns, level) leads to; false when stopped.
template <class Select>
bool search(const BoxTree& tree, std::uint32_t node, int level, const Select& select,
            BoxTree::Visit visit) {
  const NodePool& pool = tree.nodes(level);
  std::uint64_t selected = select(pool.columns(node), level);
  for (; selected != 0; selected &= selected - 1) {
    const int branch = std::countr_zero(selected);
    const bool more = level == 0 ? visit(pool.box(node, branch), {node, branch})
                                 : search(tree, pool.child(node, branch), level - 1, select, visit);
    if (!more) return false;
  }
  return true;
}

template <class Select>
bool search(const BoxTree& tree, const Select& select, BoxTree::Visit visit) {
  return tree.height() == 0 || search(tree, tree.root(), tree.height() - 1, select, visit);
}

bool descend_from(const BoxTree& tree, const BoxTree::Subtree& from, BoxTree::Enter enter,
                  BoxTree::Visit visit) {
  const auto [node, level] = from;
  const NodePool& pool = tree.nodes(level);
  for (int branch = 0; branch < pool.count(node); ++branch) {
    const CellBox box = pool.box(node, branch);
    if (!enter(box)) continue;
    const bool more = level == 0
                          ? visit(box, {node, branch})
                          : descend_from(tree, {pool.child(node, branch), level - 1}, enter, visit);
    if (!more) return false;
  }
  return true;
}

/// A search for what a beam crosses before a limit that falls as things are found.
class LimitedSearch {
 public:
  LimitedSearch(const BoxTree& tree, const Beam& beam, BoxTree::VisitInOrder visit)
      : tree_(tree), beam_(beam), inverse_(beam.direction().cwiseInverse()), visit_(visit) {}

  /// Visits the items below `node`, branches that may be entered first before others.
  void below(std::uint32_t node, int level) {
    const NodePool& pool = tree_.nodes(level);
    node_tests::Measures enter;
    std::uint64_t crossed = node_tests::may_cross(pool.columns(node), beam_, inverse_, enter);
    std::array<std::uint8_t, kMaxBranches> order;
    std::size_t count = 0;
    for (; crossed != 0; crossed &= crossed - 1) {
      const auto branch = static_cast<std::size_t>(std::countr_zero(crossed));
      std::size_t place = count++;
      for (; place > 0 && enter[branch] < enter[order[place - 1]]; --place) {
        order[place] = order[place - 1];
      }
      order[place] = static_cast<std::uint8_t>(branch);
    }
    for (std::size_t i = 0; i < count && enter[order[i]] < limit_; ++i) {
      if (level > 0) {
        below(pool.child(node, order[i]), level - 1);
      } else {
        item(pool.box(node, order[i]), {node, order[i]});
      }
    }
  }

 private:
  void item(const CellBox& box, BoxTree::Place place) {
    const auto part = crossing(beam_, box);
    if (part && part->enter < limit_) limit_ = std::min(limit_, visit_(box, place, part->enter));
  }

  const BoxTree& tree_;
  const Beam& beam_;
  Vector3d inverse_;
  BoxTree::VisitInOrder visit_;
  double limit_ = std::numeric_limits<double>::infinity();
};

}  // namespace

const std::byte* BoxTree::find(const CellBox& box) const {
  if (height_ == 0) return nullptr;
  const auto [leaf, branch] = node_tests::find_item(inner_, leaves_, root_, height_ - 1, box);
  return leaf == NodePool::kNone ? nullptr : leaves_.content(leaf, branch);
}

bool BoxTree::for_each(Visit visit) const {
  return search(
      *this, [](const BranchColumns& columns, int) { return node_tests::all(columns); }, visit);
}

bool BoxTree::overlapping(const CellBox& region, Visit visit) const {
  if (region.empty()) return true;
  return search(
      *this,
      [&](const BranchColumns& columns, int) { return node_tests::overlapping(columns, region); },
      visit);
}

bool BoxTree::contained_in(const CellBox& region, Visit visit) const {
  if (region.empty()) return true;
  return search(
      *this,
      [&](const BranchColumns& columns, int level) {
        return level == 0 ? node_tests::contained_in(columns, region)
                          : node_tests::overlapping(columns, region);
      },
      visit);
}

bool BoxTree::containing(const Cell& cell, Visit visit) const {
  if (!within_limits(cell)) return true;
  const CellBox box = box_of(cell);
  return search(
      *this, [&](const BranchColumns& columns, int) { return node_tests::enclosing(columns, box); },
      visit);
}

bool BoxTree::crossed_by(const Beam& beam, Visit visit) const {
  return search(
      *this,
      [&](const BranchColumns& columns, int) {
        node_tests::Measures enter;
        return node_tests::crossed(columns, beam, enter);
      },
      visit);
}

void BoxTree::crossed_until(const Beam& beam, VisitInOrder visit) const {
  if (height_ == 0) return;
  LimitedSearch(*this, beam, visit).below(root_, height_ - 1);
}

bool BoxTree::descend(Enter enter, Visit visit) const {
  return height_ == 0 || descend_from(*this, {root_, height_ - 1}, enter, visit);
}

bool BoxTree::descend(const Subtree& below, Enter enter, Visit visit) const {
  return descend_from(*this, below, enter, visit);
}

std::vector<BoxTree::Subtree> BoxTree::subtrees(std::size_t least, Enter enter) const {
  std::vector<Subtree> found;
  if (height_ > 0) found.push_back({root_, height_ - 1});
  for (int level = height_ - 1; level > 0 && found.size() < least; --level) {
    std::vector<Subtree> below;
    for (const Subtree& subtree : found) {
      for (int branch = 0; branch < inner_.count(subtree.node); ++branch) {
        if (!enter(inner_.box(subtree.node, branch))) continue;
        below.push_back({inner_.child(subtree.node, branch), level - 1});
      }
    }
    found = std::move(below);
  }
  return found;
}

}  // namespace rmap
