#pragma once

#include <memory>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/rtree/box_tree.hpp>
#include <rmap/rtree/options.hpp>

namespace rmap::test {

/// Guttman's partition of an overfull node, written down as in the paper: for each box whether
/// it goes to the second group.
std::vector<bool> plain_partition(const std::vector<CellBox>& boxes, int min_branches, Split split);

/// Guttman's R-tree with nodes on the heap and nothing clever: the twin of BoxTree, which must
/// have the same nodes with the same branches in the same order after the same calls.
class PlainTree {
 public:
  explicit PlainTree(const RTreeOptions& options) : options_(options) {}

  void insert(const CellBox& box, int payload);
  /// Erases the item found first when branches are searched in order.
  bool erase(const CellBox& box);
  /// Whether `tree`, whose payloads are ints, has this very shape and content.
  bool same_as(const BoxTree& tree) const;

 private:
  struct Node;
  struct Branch {
    CellBox box;
    std::shared_ptr<Node> child;  // of inner nodes
    int payload = 0;              // of leaves
  };
  struct Node {
    int level = 0;
    std::vector<Branch> branches;
  };

  static CellBox bounds(const Node& node);
  void insert_branch(const Branch& branch, int level);
  std::shared_ptr<Node> insert_below(Node& node, const Branch& branch, int level);
  std::shared_ptr<Node> split(Node& node) const;
  bool erase_below(Node& node, const CellBox& box, std::vector<std::shared_ptr<Node>>& orphans);
  static bool same(const Node& node, const BoxTree& tree, std::uint32_t id);

  RTreeOptions options_;
  std::shared_ptr<Node> root_;
};

}  // namespace rmap::test
