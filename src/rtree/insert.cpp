#include "rtree/node_tests.hpp"
#include "rtree/split.hpp"

#include <array>

#include <rmap/rtree/box_tree.hpp>

namespace rmap {

namespace {

/// A child's id as the content of a branch.
const std::byte* bytes_of(const std::uint32_t& child) {
  return reinterpret_cast<const std::byte*>(&child);
}

}  // namespace

void BoxTree::insert(const CellBox& box, const std::byte* payload) {
  check_box(box, std::nullopt);
  if (height_ == 0) {
    root_ = leaves_.allocate();
    height_ = 1;
  }
  insert_at(0, {box, payload});
  ++size_;
}

/// Puts `branch` into a node of `level`. The tree grows by a level when the root splits.
void BoxTree::insert_at(int level, const Branch& branch) {
  const std::uint32_t sibling = insert_below(root_, height_ - 1, branch, level);
  if (sibling == NodePool::kNone) return;
  const NodePool& halves = nodes(height_ - 1);
  const std::uint32_t root = inner_.allocate();
  inner_.append(root, halves.bounds(root_), bytes_of(root_));
  inner_.append(root, halves.bounds(sibling), bytes_of(sibling));
  root_ = root;
  ++height_;
}

/// Puts `branch` into a node of level `target` below `node`, which is of `level`. Returns the
/// new sibling of `node` when it had to be split, else kNone.
std::uint32_t BoxTree::insert_below(std::uint32_t node, int level, const Branch& branch,
                                    int target) {
  if (level == target) {
    if (nodes(level).full(node)) {
      // From here on nothing throws: at most each level and the root take a new node.
      leaves_.reserve(1);
      inner_.reserve(static_cast<std::size_t>(height_));
    }
    return add_branch(node, level, branch);
  }
  const int chosen = least_enlarged(node, level, branch.box);
  const std::uint32_t child = inner_.child(node, chosen);
  const std::uint32_t sibling = insert_below(child, level - 1, branch, target);
  if (sibling == NodePool::kNone) {
    inner_.set_box(node, chosen, united(inner_.box(node, chosen), branch.box));
    return NodePool::kNone;
  }
  const NodePool& halves = nodes(level - 1);
  inner_.set_box(node, chosen, halves.bounds(child));
  return add_branch(node, level, {halves.bounds(sibling), bytes_of(sibling)});
}

/// Guttman's ChooseLeaf in one node: the branch that grows least to hold `box`; ties: the
/// smaller volume, then the child with fewer branches.
int BoxTree::least_enlarged(std::uint32_t node, int level, const CellBox& box) const {
  const BranchColumns columns = inner_.columns(node);
  node_tests::Measures volume;
  node_tests::Measures enlargement;
  node_tests::enlargements(columns, box, volume, enlargement);
  const auto branches_below = [&](std::size_t branch) {
    return nodes(level - 1).count(inner_.child(node, static_cast<int>(branch)));
  };
  std::size_t best = 0;
  for (std::size_t i = 1; i < static_cast<std::size_t>(columns.count); ++i) {
    if (enlargement[i] != enlargement[best]) {
      if (enlargement[i] < enlargement[best]) best = i;
    } else if (volume[i] != volume[best]) {
      if (volume[i] < volume[best]) best = i;
    } else if (branches_below(i) < branches_below(best)) {
      best = i;
    }
  }
  return static_cast<int>(best);
}

/// Adds `branch` to `node`, which is split when it is full: then returns the new sibling.
std::uint32_t BoxTree::add_branch(std::uint32_t node, int level, const Branch& branch) {
  if (pool(level).full(node)) return split(node, level, branch);
  pool(level).append(node, branch.box, branch.content);
  return NodePool::kNone;
}

std::uint32_t BoxTree::split(std::uint32_t node, int level, const Branch& branch) {
  NodePool& nodes = pool(level);
  const int old_count = nodes.count(node);
  std::array<CellBox, kMaxBranches + 1> boxes;
  for (int i = 0; i < old_count; ++i) boxes[static_cast<std::size_t>(i)] = nodes.box(node, i);
  const auto newcomer = static_cast<std::size_t>(old_count);
  boxes[newcomer] = branch.box;
  const Partition second =
      partition(std::span(boxes).first(newcomer + 1), options_.min_branches, options_.split);

  const std::uint32_t sibling = nodes.allocate();
  int kept = 0;
  for (int i = 0; i < old_count; ++i) {
    if (second[static_cast<std::size_t>(i)]) {
      nodes.append(sibling, boxes[static_cast<std::size_t>(i)], nodes.content(node, i));
    } else {
      nodes.copy_branch(node, i, kept++);
    }
  }
  nodes.truncate(node, kept);
  nodes.append(second[newcomer] ? sibling : node, branch.box, branch.content);
  return sibling;
}

}  // namespace rmap
