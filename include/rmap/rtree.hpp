#pragma once

#include <cstddef>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <rmap/beam.hpp>
#include <rmap/cell.hpp>
#include <rmap/rtree/box_tree.hpp>
#include <rmap/rtree/options.hpp>
#include <rmap/rtree/statistics.hpp>

namespace rmap {

/// A height-balanced hierarchy of minimum bounding cuboids over boxes of cells
/// [RMAP 2, Guttman 1984]. Each item is a box and a payload; boxes may overlap
/// and occur more than once. Knows nothing of occupancy.
///
/// The shape of the tree follows from the sequence of calls alone. References and
/// pointers to payloads are valid until the tree changes; a visitor may change
/// payloads, not the tree. Const members may run in several threads at a time.
/// A copy is deep and costs a block copy of each 16 KiB page.
///
/// Visitors are called as visit(const CellBox&, Payload&) and return nothing, or a
/// bool: false stops the search, which then returns false. Const trees hand out
/// const Payload&. Unless said otherwise items come in the order of the tree.
template <class Payload>
class RTree {
  static_assert(std::is_trivially_copyable_v<Payload>,
                "nodes copy payloads as bytes: put an index here for anything larger");
  static_assert(alignof(Payload) <= __STDCPP_DEFAULT_NEW_ALIGNMENT__);

 public:
  struct Item {
    CellBox box;
    Payload payload;
  };
  struct Neighbour {
    CellBox box;
    Payload payload;
    /// From the point to the closed box, in cells; 0 when the point is inside.
    double distance;
  };

  /// Throws Error(input) naming the option that is out of its range.
  explicit RTree(const RTreeOptions& options = {})
      : tree_(options, sizeof(Payload), alignof(Payload)) {}

  /// A tree of full nodes, the last two of a level excepted; far faster than inserting one by
  /// one, and with less overlap. Throws as insert().
  static RTree bulk_load(std::span<const Item> items, const RTreeOptions& options = {},
                         Packing packing = Packing::sort_tile_recursive) {
    RTree tree(options);
    std::vector<CellBox> boxes;
    boxes.reserve(items.size());
    for (const Item& item : items) boxes.push_back(item.box);
    tree.tree_.load(
        boxes, [&](std::size_t i) { return bytes_of(items[i].payload); }, packing);
    return tree;
  }

  /// Adds an item, whether or not there is one with this box already. Each level descends into
  /// the branch that grows least; ties: the smaller volume, then the child with fewer branches.
  /// Throws Error(input) when the box is empty or, with `leaf_edge`, no cube of that edge,
  /// Error(limit) when it leaves all_cells(). Whatever it throws, the tree stays as it was.
  void insert(const CellBox& box, const Payload& payload) {
    const Payload copy = payload;  // it may stand in a node that is about to be split
    tree_.insert(box, bytes_of(copy));
  }

  /// Erases one item with exactly this box; false when there is none. A node left with fewer
  /// than n branches is dissolved and its branches are inserted anew on their level. Memory
  /// stays with the tree until clear() or repack(). Should memory run out meanwhile
  /// (std::bad_alloc), branches may be lost, and the tree is fit for clear() only.
  bool erase(const CellBox& box) {
    return tree_.erase(box, [](BoxTree::Place) { return true; });
  }
  /// The same for the first item with exactly this box for which match(const Payload&) holds.
  template <class Match>
  bool erase_if(const CellBox& box, Match&& match) {
    const BoxTree& tree = tree_;
    return tree_.erase(
        box, [&](BoxTree::Place place) -> bool { return match(payload_of(tree, place)); });
  }

  /// The payload of the first item with exactly this box, or null.
  Payload* find(const CellBox& box) { return const_cast<Payload*>(std::as_const(*this).find(box)); }
  const Payload* find(const CellBox& box) const {
    const std::byte* const payload = tree_.find(box);
    return payload == nullptr ? nullptr : std::launder(reinterpret_cast<const Payload*>(payload));
  }

  /// Drops all items and gives back all memory.
  void clear() { tree_.clear(); }
  std::size_t size() const { return tree_.size(); }
  bool empty() const { return tree_.size() == 0; }
  /// Number of levels: 0 when empty, 1 when the root is a leaf.
  int height() const { return tree_.height(); }
  /// The MBRC of all items; the empty box when there are none.
  CellBox bounds() const { return tree_.bounds(); }
  /// As given, with `min_branches` resolved.
  const RTreeOptions& options() const { return tree_.options(); }

  /// Every item.
  template <class Visit>
  bool for_each(Visit&& visit) {
    return tree_.for_each(visitor(tree_, visit));
  }
  template <class Visit>
  bool for_each(Visit&& visit) const {
    return tree_.for_each(visitor(tree_, visit));
  }

  /// The items that share a cell with `region`, which may be empty or leave the limits.
  template <class Visit>
  bool overlapping(const CellBox& region, Visit&& visit) {
    return tree_.overlapping(region, visitor(tree_, visit));
  }
  template <class Visit>
  bool overlapping(const CellBox& region, Visit&& visit) const {
    return tree_.overlapping(region, visitor(tree_, visit));
  }

  /// The items that lie in `region` as a whole.
  template <class Visit>
  bool contained_in(const CellBox& region, Visit&& visit) {
    return tree_.contained_in(region, visitor(tree_, visit));
  }
  template <class Visit>
  bool contained_in(const CellBox& region, Visit&& visit) const {
    return tree_.contained_in(region, visitor(tree_, visit));
  }

  /// The items that hold `cell`.
  template <class Visit>
  bool containing(const Cell& cell, Visit&& visit) {
    return tree_.containing(cell, visitor(tree_, visit));
  }
  template <class Visit>
  bool containing(const Cell& cell, Visit&& visit) const {
    return tree_.containing(cell, visitor(tree_, visit));
  }

  /// The items that `beam` crosses: exactly those for which crossing(beam, box) says so.
  template <class Visit>
  bool crossed_by(const Beam& beam, Visit&& visit) {
    return tree_.crossed_by(beam, visitor(tree_, visit));
  }
  template <class Visit>
  bool crossed_by(const Beam& beam, Visit&& visit) const {
    return tree_.crossed_by(beam, visitor(tree_, visit));
  }

  /// The same from front to back: visit(const CellBox&, Payload&, double enter) -> double.
  /// Items come in the order of their parameter of entry, exactly, whatever the shape of the
  /// tree; at equal entries, which only boxes that overlap can have, the smaller box.min comes
  /// first, then the smaller box.max (x before y before z); only identical boxes come in the
  /// order of the tree. The answer is a limit: items with enter >= limit are not visited any
  /// more. 1 or more asks for all, `enter` or less stops; a limit never rises again.
  template <class Visit>
  void crossed_in_order(const Beam& beam, Visit&& visit) {
    tree_.crossed_in_order(beam, visitor_in_order(tree_, visit));
  }
  template <class Visit>
  void crossed_in_order(const Beam& beam, Visit&& visit) const {
    tree_.crossed_in_order(beam, visitor_in_order(tree_, visit));
  }

  /// The same without an order, for whoever looks for the least of something: node by node the
  /// branches that the beam enters first come first. Costs far less than the exact order.
  template <class Visit>
  void crossed_until(const Beam& beam, Visit&& visit) const {
    tree_.crossed_until(beam, visitor_in_order(tree_, visit));
  }

  /// Descends into every branch whose box enter(const CellBox&) -> bool accepts. It is asked
  /// about MBRCs and, at the leaves, about the items' own boxes, each right before what lies
  /// behind it is visited; so a predicate that accepts a box must accept all that contain it.
  template <class Enter, class Visit>
  bool descend(Enter&& enter, Visit&& visit) {
    return tree_.descend(enter, visitor(tree_, visit));
  }
  template <class Enter, class Visit>
  bool descend(Enter&& enter, Visit&& visit) const {
    return tree_.descend(enter, visitor(tree_, visit));
  }
  /// Parts in which a descent may be made, beside one another: of a level that has at least
  /// `least` nodes to be entered, or the lowest. In order they give what a whole descent does.
  using Subtree = BoxTree::Subtree;
  template <class Enter>
  std::vector<Subtree> subtrees(std::size_t least, Enter&& enter) const {
    return tree_.subtrees(least, enter);
  }
  template <class Enter, class Visit>
  bool descend(const Subtree& below, Enter&& enter, Visit&& visit) const {
    return tree_.descend(below, enter, visitor(tree_, visit));
  }

  /// The item nearest to `point` (cell units), by the distance to its closed box; nothing when
  /// the tree is empty. Throws Error(limit) when the point is not finite or beyond the limits.
  std::optional<Neighbour> nearest(const Vector3d& point) const {
    std::optional<Neighbour> found;
    tree_.nearest(point, 1, [&](const CellBox& box, BoxTree::Place place, double distance) {
      found = Neighbour{box, payload_of(tree_, place), distance};
    });
    return found;
  }
  /// The k nearest items, or all if there are fewer, nearest first; ties as in crossed_in_order.
  std::vector<Neighbour> nearest_k(const Vector3d& point, std::size_t k) const {
    std::vector<Neighbour> found;
    tree_.nearest(point, k, [&](const CellBox& box, BoxTree::Place place, double distance) {
      found.push_back({box, payload_of(tree_, place), distance});
    });
    return found;
  }

  /// Builds the tree anew out of full nodes, as bulk_load does, and gives back unused memory.
  void repack(Packing packing = Packing::sort_tile_recursive) { tree_.repack(packing); }

  /// Cost: a pass over the tree; nodes whose branches overlap take up to M^3 steps.
  RTreeStatistics statistics() const { return tree_.statistics(); }
  std::size_t bytes_in_use() const { return tree_.bytes_in_use(); }

  /// Verifies every invariant: all leaves on level 0, M and n (the root excepted), MBRCs
  /// tight, one parent for each node, counts, boxes within the limits, the lists of free
  /// nodes. Nothing when sound, else a sentence that says what fails and where.
  std::optional<std::string> check() const { return tree_.check(); }

 private:
  static const std::byte* bytes_of(const Payload& payload) {
    return reinterpret_cast<const std::byte*>(&payload);
  }
  static Payload& payload_of(BoxTree& tree, BoxTree::Place place) {
    return *std::launder(reinterpret_cast<Payload*>(tree.payload(place)));
  }
  static const Payload& payload_of(const BoxTree& tree, BoxTree::Place place) {
    return *std::launder(reinterpret_cast<const Payload*>(tree.payload(place)));
  }

  template <class Tree, class Visit>
  static auto visitor(Tree& tree, Visit& visit) {
    return [&tree, &visit](const CellBox& box, BoxTree::Place place) -> bool {
      if constexpr (std::is_void_v<decltype(visit(box, payload_of(tree, place)))>) {
        visit(box, payload_of(tree, place));
        return true;
      } else {
        return visit(box, payload_of(tree, place));
      }
    };
  }
  template <class Tree, class Visit>
  static auto visitor_in_order(Tree& tree, Visit& visit) {
    return [&tree, &visit](const CellBox& box, BoxTree::Place place, double enter) -> double {
      return visit(box, payload_of(tree, place), enter);
    };
  }

  BoxTree tree_;
};

}  // namespace rmap
