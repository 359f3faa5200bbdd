#include "rtree/text.hpp"

#include <utility>

#include <fmt/format.h>

#include <rmap/rtree/box_tree.hpp>

namespace rmap {

namespace {

/// Walks a tree that may be damaged in any way; reads nothing that it has not checked.
class Checker {
 public:
  explicit Checker(const BoxTree& tree) : tree_(tree), options_(tree.options()) {}

  /// The first invariant that fails, as a sentence.
  std::optional<std::string> failure() {
    for (Pool* pool : {&leaves_, &inner_}) {
      const NodePool& nodes = pool == &leaves_ ? tree_.nodes(0) : tree_.nodes(1);
      auto in_use = nodes.slots_in_use();
      if (!in_use) return fmt::format("the list of free {} is damaged", pool->name);
      pool->in_use = std::move(*in_use);
      pool->reached.resize(pool->in_use.size(), false);
    }
    if (auto failed = check_root()) return failed;
    if (tree_.height() > 0) {
      if (auto failed = check_node(tree_.root(), tree_.height() - 1)) return failed;
    }
    if (items_ != tree_.size()) {
      return fmt::format("the leaves hold {} items, but the tree counts {}", items_, tree_.size());
    }
    for (const Pool* pool : {&leaves_, &inner_}) {
      for (std::size_t node = 0; node < pool->in_use.size(); ++node) {
        if (pool->in_use[node] && !pool->reached[node]) {
          return fmt::format("node {} of the {} has no parent", node, pool->name);
        }
      }
    }
    return std::nullopt;
  }

 private:
  struct Pool {
    const char* name;
    std::vector<bool> in_use;
    std::vector<bool> reached;
  };

  std::optional<std::string> check_root() const {
    const int height = tree_.height();
    if (height < 0) return fmt::format("the height is {}", height);
    if ((height == 0) != (tree_.root() == NodePool::kNone)) {
      return fmt::format("the height is {}, but the tree has {} root", height,
                         height == 0 ? "a" : "no");
    }
    return std::nullopt;
  }

  std::optional<std::string> check_node(std::uint32_t node, int level) {
    const std::string name = fmt::format("node {} of level {}", node, level);
    Pool& pool = level == 0 ? leaves_ : inner_;
    if (node >= pool.in_use.size()) return name + " does not exist";
    if (!pool.in_use[node]) return name + " is in the tree and in the list of free nodes";
    if (pool.reached[node]) return name + " has more than one parent";
    pool.reached[node] = true;

    const NodePool& nodes = tree_.nodes(level);
    const bool root = level == tree_.height() - 1;
    const int least = root ? (level == 0 ? 1 : 2) : options_.min_branches;
    const int count = nodes.count(node);
    if (count < least || count > options_.max_branches) {
      return fmt::format("{} has {} branches: {} to {} are allowed", name, count, least,
                         options_.max_branches);
    }
    for (int branch = 0; branch < count; ++branch) {
      const CellBox box = nodes.box(node, branch);
      if (!all_cells().contains(box)) {
        return fmt::format("branch {} of {} {} is empty or beyond the limits", branch, name,
                           text_of(box));
      }
      if (level == 0) continue;
      if (auto failed = check_node(nodes.child(node, branch), level - 1)) return failed;
      const CellBox tight = tree_.nodes(level - 1).bounds(nodes.child(node, branch));
      if (!(box == tight)) {
        return fmt::format("branch {} of {} {} is not tight: its child lies {}", branch, name,
                           text_of(box), text_of(tight));
      }
    }
    if (level == 0) items_ += static_cast<std::size_t>(count);
    return std::nullopt;
  }

  const BoxTree& tree_;
  const RTreeOptions& options_;
  Pool leaves_{"leaves", {}, {}};
  Pool inner_{"inner nodes", {}, {}};
  std::size_t items_ = 0;
};

}  // namespace

std::optional<std::string> BoxTree::check() const { return Checker(*this).failure(); }

}  // namespace rmap
