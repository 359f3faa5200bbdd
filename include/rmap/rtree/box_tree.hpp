#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rmap/beam.hpp>
#include <rmap/cell.hpp>
#include <rmap/function_ref.hpp>
#include <rmap/rtree/node_pool.hpp>
#include <rmap/rtree/options.hpp>
#include <rmap/rtree/statistics.hpp>

namespace rmap {

namespace test {
struct BoxTreeDamage;
}

/// The R-tree behind RTree<Payload>, which says what each operation means: here
/// payloads are opaque bytes of a fixed size, so that the algorithms are compiled
/// once. Levels count from the leaves, level 0, to the root, level height() - 1.
///
/// Reading from several threads at a time is safe while none writes.
class BoxTree {
 public:
  /// Where an item is, until the tree changes.
  struct Place {
    std::uint32_t leaf;
    int branch;
  };
  /// A node and all that is below it, until the tree changes.
  struct Subtree {
    std::uint32_t node;
    int level;
  };
  /// Called with each item found; false stops the search.
  using Visit = FunctionRef<bool(const CellBox& box, Place place)>;
  /// Called with each item found and its parameter of entry; the limit from then on.
  using VisitInOrder = FunctionRef<double(const CellBox& box, Place place, double enter)>;
  using VisitNearest = FunctionRef<void(const CellBox& box, Place place, double distance)>;
  using Enter = FunctionRef<bool(const CellBox& box)>;
  using Match = FunctionRef<bool(Place place)>;

  /// Throws Error(input) naming the option that is out of its range.
  BoxTree(const RTreeOptions& options, std::size_t payload_size, std::size_t payload_alignment);
  BoxTree(const BoxTree& other) = default;
  BoxTree(BoxTree&& other) noexcept;
  BoxTree& operator=(const BoxTree& other);
  BoxTree& operator=(BoxTree&& other) noexcept;
  ~BoxTree() = default;

  void insert(const CellBox& box, const std::byte* payload);
  /// Erases the first item with exactly this box that `match` accepts.
  bool erase(const CellBox& box, Match match);
  /// The payload of the first item with exactly this box, or null.
  const std::byte* find(const CellBox& box) const;
  void clear();

  /// Replaces the content by items 0, 1, ... in full nodes; `payload_of(i)` is read once each.
  void load(std::span<const CellBox> boxes, FunctionRef<const std::byte*(std::size_t)> payload_of,
            Packing packing);
  void repack(Packing packing);

  bool for_each(Visit visit) const;
  bool overlapping(const CellBox& region, Visit visit) const;
  bool contained_in(const CellBox& region, Visit visit) const;
  bool containing(const Cell& cell, Visit visit) const;
  bool crossed_by(const Beam& beam, Visit visit) const;
  bool descend(Enter enter, Visit visit) const;
  bool descend(const Subtree& below, Enter enter, Visit visit) const;
  std::vector<Subtree> subtrees(std::size_t least, Enter enter) const;
  void crossed_in_order(const Beam& beam, VisitInOrder visit) const;
  void crossed_until(const Beam& beam, VisitInOrder visit) const;
  void nearest(const Vector3d& point, std::size_t k, VisitNearest visit) const;

  std::size_t size() const { return size_; }
  int height() const { return height_; }
  CellBox bounds() const;
  const RTreeOptions& options() const { return options_; }
  std::byte* payload(Place place) { return leaves_.content(place.leaf, place.branch); }
  const std::byte* payload(Place place) const { return leaves_.content(place.leaf, place.branch); }

  RTreeStatistics statistics() const;
  std::size_t bytes_in_use() const { return inner_.bytes_in_use() + leaves_.bytes_in_use(); }
  std::optional<std::string> check() const;

  /// The root's id in nodes(height() - 1); NodePool::kNone when the tree is empty.
  std::uint32_t root() const { return root_; }
  /// The nodes of a level; all inner levels share one pool.
  const NodePool& nodes(int level) const { return level == 0 ? leaves_ : inner_; }

 private:
  friend struct test::BoxTreeDamage;  // the tests of check() break a tree on purpose

  /// A branch on its way into a node; the content is a payload or a child's id.
  struct Branch {
    CellBox box;
    const std::byte* content;
  };
  /// A node that erase took out of the tree since it has too few branches.
  struct Orphan {
    std::uint32_t node;
    int level;
  };

  NodePool& pool(int level) { return level == 0 ? leaves_ : inner_; }
  void check_box(const CellBox& box, std::optional<std::size_t> item) const;

  void insert_at(int level, const Branch& branch);
  std::uint32_t insert_below(std::uint32_t node, int level, const Branch& branch, int target);
  int least_enlarged(std::uint32_t node, int level, const CellBox& box) const;
  std::uint32_t add_branch(std::uint32_t node, int level, const Branch& branch);
  std::uint32_t split(std::uint32_t node, int level, const Branch& branch);

  bool erase_below(std::uint32_t node, int level, const CellBox& box, Match match,
                   std::vector<Orphan>& orphans);
  void reinsert(const std::vector<Orphan>& orphans);
  void collapse_root();

  void build(std::span<const CellBox> boxes, FunctionRef<const std::byte*(std::size_t)> payload_of,
             Packing packing);

  RTreeOptions options_;
  NodePool inner_;
  NodePool leaves_;
  std::uint32_t root_ = NodePool::kNone;
  int height_ = 0;
  std::size_t size_ = 0;
};

}  // namespace rmap
