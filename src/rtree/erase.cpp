#include "rtree/node_tests.hpp"

#include <bit>

#include <rmap/rtree/box_tree.hpp>

namespace rmap {

bool BoxTree::erase(const CellBox& box, Match match) {
  if (height_ == 0) return false;
  std::vector<Orphan> orphans;
  if (!erase_below(root_, height_ - 1, box, match, orphans)) return false;
  --size_;
  reinsert(orphans);
  collapse_root();
  return true;
}

/// Erases the item from the subtree of `node`; on the way back up, nodes with too few branches
/// leave the tree as orphans (Guttman's CondenseTree).
bool BoxTree::erase_below(std::uint32_t node, int level, const CellBox& box, Match match,
                          std::vector<Orphan>& orphans) {
  NodePool& nodes = pool(level);
  if (level == 0) {
    std::uint64_t candidates = node_tests::equal_to(nodes.columns(node), box);
    for (; candidates != 0; candidates &= candidates - 1) {
      const int branch = std::countr_zero(candidates);
      if (!match({node, branch})) continue;
      nodes.remove(node, branch);
      return true;
    }
    return false;
  }
  std::uint64_t candidates = node_tests::enclosing(nodes.columns(node), box);
  for (; candidates != 0; candidates &= candidates - 1) {
    const int branch = std::countr_zero(candidates);
    const std::uint32_t child = nodes.child(node, branch);
    if (!erase_below(child, level - 1, box, match, orphans)) continue;
    if (pool(level - 1).count(child) < options_.min_branches) {
      orphans.push_back({child, level - 1});
      nodes.remove(node, branch);
    } else {
      nodes.set_box(node, branch, pool(level - 1).bounds(child));
    }
    return true;
  }
  return false;
}

/// Inserts the branches of the orphans anew, each on the level it comes from.
void BoxTree::reinsert(const std::vector<Orphan>& orphans) {
  for (const Orphan& orphan : orphans) {
    NodePool& nodes = pool(orphan.level);
    for (int i = 0; i < nodes.count(orphan.node); ++i) {
      insert_at(orphan.level, {nodes.box(orphan.node, i), nodes.content(orphan.node, i)});
    }
    nodes.release(orphan.node);
  }
}

/// An inner root with one branch gives way to its child, an empty leaf to the empty tree.
void BoxTree::collapse_root() {
  while (height_ > 1 && inner_.count(root_) == 1) {
    const std::uint32_t child = inner_.child(root_, 0);
    inner_.release(root_);
    root_ = child;
    --height_;
  }
  if (height_ == 1 && leaves_.count(root_) == 0) {
    leaves_.release(root_);
    root_ = NodePool::kNone;
    height_ = 0;
  }
}

}  // namespace rmap
