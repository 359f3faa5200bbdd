#include "rtree/node_tests.hpp"

#include <bit>

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

bool descend_from(const BoxTree& tree, std::uint32_t node, int level, BoxTree::Enter enter,
                  BoxTree::Visit visit) {
  const NodePool& pool = tree.nodes(level);
  for (int branch = 0; branch < pool.count(node); ++branch) {
    const CellBox box = pool.box(node, branch);
    if (!enter(box)) continue;
    const bool more = level == 0
                          ? visit(box, {node, branch})
                          : descend_from(tree, pool.child(node, branch), level - 1, enter, visit);
    if (!more) return false;
  }
  return true;
}

}  // namespace

std::optional<BoxTree::Place> BoxTree::find(const CellBox& box) const {
  std::optional<Place> found;
  search(
      *this,
      [&](const BranchColumns& columns, int level) {
        return level == 0 ? node_tests::equal_to(columns, box)
                          : node_tests::enclosing(columns, box);
      },
      [&](const CellBox&, Place place) {
        found = place;
        return false;
      });
  return found;
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

bool BoxTree::descend(Enter enter, Visit visit) const {
  return height_ == 0 || descend_from(*this, root_, height_ - 1, enter, visit);
}

}  // namespace rmap
