#include "rtree/plain_tree.hpp"

#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>

namespace rmap::test {

namespace {

double volume(const CellBox& box) {
  const Vector3d edges = box.max.cast<double>() - box.min.cast<double>();
  return edges.x() * edges.y() * edges.z();
}

double growth(const CellBox& box, const CellBox& newcomer) {
  return volume(united(box, newcomer)) - volume(box);
}

std::pair<std::size_t, std::size_t> quadratic_seeds(const std::vector<CellBox>& boxes) {
  std::pair<std::size_t, std::size_t> seeds;
  double most = -INFINITY;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      const double waste = volume(united(boxes[i], boxes[j])) - volume(boxes[i]) - volume(boxes[j]);
      if (waste > most) std::tie(most, seeds) = std::make_tuple(waste, std::make_pair(i, j));
    }
  }
  return seeds;
}

std::pair<std::size_t, std::size_t> linear_seeds(const std::vector<CellBox>& boxes) {
  std::pair<std::size_t, std::size_t> seeds;
  double most = -INFINITY;
  CellBox whole = boxes[0];
  for (const CellBox& box : boxes) whole = united(whole, box);
  for (int axis = 0; axis < 3; ++axis) {
    std::size_t upper = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (boxes[i].min[axis] > boxes[upper].min[axis]) upper = i;
    }
    std::size_t lower = boxes.size();
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (i == upper) continue;
      if (lower == boxes.size() || boxes[i].max[axis] < boxes[lower].max[axis]) lower = i;
    }
    const double gap = double{boxes[upper].min[axis] * 1.0} - boxes[lower].max[axis];
    const double separation = gap / static_cast<double>(whole.extent()[axis]);
    if (separation > most) {
      most = separation;
      seeds = std::minmax(lower, upper);
    }
  }
  return seeds;
}

}  // namespace

std::vector<bool> plain_partition(const std::vector<CellBox>& boxes, int min_branches,
                                  Split split) {
  const auto [first, second] =
      split == Split::quadratic ? quadratic_seeds(boxes) : linear_seeds(boxes);
  const auto least = static_cast<std::size_t>(min_branches);
  std::vector<std::size_t> groups[2] = {{first}, {second}};
  CellBox bounds[2] = {boxes[first], boxes[second]};
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (i != first && i != second) left.push_back(i);
  }
  while (!left.empty()) {
    std::size_t chosen = 0;
    int group = 0;
    if (groups[0].size() + left.size() <= least) {
      group = 0;
    } else if (groups[1].size() + left.size() <= least) {
      group = 1;
    } else {
      const auto preference = [&](std::size_t position) {
        const CellBox& box = boxes[left[position]];
        return std::abs(growth(bounds[0], box) - growth(bounds[1], box));
      };
      for (std::size_t i = 1; split == Split::quadratic && i < left.size(); ++i) {
        if (preference(i) > preference(chosen)) chosen = i;
      }
      const CellBox& box = boxes[left[chosen]];
      const auto cost = [&](int g) {
        return std::make_tuple(growth(bounds[g], box), volume(bounds[g]), groups[g].size());
      };
      group = cost(1) < cost(0) ? 1 : 0;
    }
    groups[group].push_back(left[chosen]);
    bounds[group] = united(bounds[group], boxes[left[chosen]]);
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(chosen));
  }
  std::vector<bool> in_second(boxes.size(), false);
  for (const std::size_t i : groups[1]) in_second[i] = true;
  return in_second;
}

CellBox PlainTree::bounds(const Node& node) {
  CellBox box = node.branches.front().box;
  for (const Branch& branch : node.branches) box = united(box, branch.box);
  return box;
}

void PlainTree::insert(const CellBox& box, int payload) {
  if (!root_) root_ = std::make_shared<Node>();
  insert_branch({box, nullptr, payload}, 0);
}

void PlainTree::insert_branch(const Branch& branch, int level) {
  const auto sibling = insert_below(*root_, branch, level);
  if (!sibling) return;
  auto root = std::make_shared<Node>();
  root->level = root_->level + 1;
  root->branches = {{bounds(*root_), root_}, {bounds(*sibling), sibling}};
  root_ = root;
}

std::shared_ptr<PlainTree::Node> PlainTree::insert_below(Node& node, const Branch& branch,
                                                         int level) {
  if (node.level == level) {
    node.branches.push_back(branch);
  } else {
    const auto cost = [&](const Branch& candidate) {
      return std::make_tuple(growth(candidate.box, branch.box), volume(candidate.box),
                             candidate.child->branches.size());
    };
    Branch* best = &node.branches.front();
    for (Branch& candidate : node.branches) {
      if (cost(candidate) < cost(*best)) best = &candidate;
    }
    const auto sibling = insert_below(*best->child, branch, level);
    best->box = bounds(*best->child);
    if (sibling) node.branches.push_back({bounds(*sibling), sibling});
  }
  const auto max = static_cast<std::size_t>(options_.max_branches);
  return node.branches.size() > max ? split(node) : nullptr;
}

std::shared_ptr<PlainTree::Node> PlainTree::split(Node& node) const {
  std::vector<CellBox> boxes;
  for (const Branch& branch : node.branches) boxes.push_back(branch.box);
  const auto in_second = plain_partition(boxes, options_.min_branches, options_.split);
  auto sibling = std::make_shared<Node>();
  sibling->level = node.level;
  std::vector<Branch> kept;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    (in_second[i] ? sibling->branches : kept).push_back(node.branches[i]);
  }
  node.branches = kept;
  return sibling;
}

bool PlainTree::erase(const CellBox& box) {
  std::vector<std::shared_ptr<Node>> orphans;
  if (!root_ || !erase_below(*root_, box, orphans)) return false;
  for (const auto& orphan : orphans) {
    for (const Branch& branch : orphan->branches) insert_branch(branch, orphan->level);
  }
  while (root_->level > 0 && root_->branches.size() == 1) root_ = root_->branches.front().child;
  if (root_->branches.empty()) root_ = nullptr;
  return true;
}

bool PlainTree::erase_below(Node& node, const CellBox& box,
                            std::vector<std::shared_ptr<Node>>& orphans) {
  for (Branch& branch : node.branches) {
    if (node.level == 0) {
      if (!(branch.box == box)) continue;
    } else {
      if (!branch.box.contains(box) || !erase_below(*branch.child, box, orphans)) continue;
      if (branch.child->branches.size() >= static_cast<std::size_t>(options_.min_branches)) {
        branch.box = bounds(*branch.child);
        return true;
      }
      orphans.push_back(branch.child);
    }
    std::swap(branch, node.branches.back());
    node.branches.pop_back();
    return true;
  }
  return false;
}

bool PlainTree::same_as(const BoxTree& tree) const {
  if (!root_) return tree.height() == 0 && tree.root() == NodePool::kNone;
  return tree.height() == root_->level + 1 && same(*root_, tree, tree.root());
}

bool PlainTree::same(const Node& node, const BoxTree& tree, std::uint32_t id) {
  const NodePool& pool = tree.nodes(node.level);
  if (static_cast<std::size_t>(pool.count(id)) != node.branches.size()) return false;
  for (int i = 0; i < pool.count(id); ++i) {
    const Branch& branch = node.branches[static_cast<std::size_t>(i)];
    if (!(pool.box(id, i) == branch.box)) return false;
    if (node.level > 0) {
      if (!same(*branch.child, tree, pool.child(id, i))) return false;
    } else {
      int payload = 0;
      std::memcpy(&payload, pool.content(id, i), sizeof(payload));
      if (payload != branch.payload) return false;
    }
  }
  return true;
}

}  // namespace rmap::test
