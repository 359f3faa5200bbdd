#pragma once

#include "grid/change_log.hpp"

#include <memory>
#include <optional>
#include <span>

#include <rmap/beam.hpp>
#include <rmap/leaf.hpp>
#include <rmap/report.hpp>

namespace rmap {

/// Number of a leaf branch: stable while the leaf exists, then used again.
using LeafId = std::uint32_t;

/// Some cells of a leaf.
struct MarkedLeaf {
  LeafId id;
  Cell origin;
  CellMask cells;
};

/// The cells of a grid: leaf branches in an R-tree, and what they hold. The two
/// layouts differ only in the edge of a leaf and in how its cells are stored;
/// everything above works on leaves and does not know which one it is.
class LeafStore {
 public:
  static std::unique_ptr<LeafStore> make(const Options& options);
  virtual ~LeafStore() = default;
  virtual std::unique_ptr<LeafStore> clone() const = 0;

  // --- What lies where -------------------------------------------------------

  std::int32_t edge() const { return tree_.options().leaf_edge; }
  /// Lowest cell of the leaf that holds or would hold `cell`.
  Cell origin_of(const Cell& cell) const { return edge() == 1 ? cell : block_origin(cell); }
  BlockPosition position_of(const Cell& cell) const {
    return edge() == 1 ? 0 : block_position(cell);
  }
  /// use(origin, cells) for the leaves that cells of the block at `block` belong to.
  template <class Use>
  void for_each_leaf_of(const Cell& block, const CellMask& cells, Use&& use) const {
    if (edge() == kBlockEdge) return use(block, cells);
    cells.for_each([&](BlockPosition position) {
      use(Cell(block + block_offset(position)), CellMask::single(0));
    });
  }

  // --- Reading ---------------------------------------------------------------

  virtual std::optional<LeafId> find(const Cell& origin) const = 0;
  /// The leaves that lie in the block at `block`.
  virtual void visit_block(const Cell& block,
                           FunctionRef<void(LeafId, const Cell& origin)> visit) const = 0;
  /// Value of a cell, null where it does not exist.
  virtual const Value* find_value(const Cell& cell) const = 0;
  virtual Leaf leaf(LeafId id, const Cell& origin) const = 0;

  /// Visits return false when `visit` did.
  bool visit(const CellBox& region, FunctionRef<bool(LeafId, const Leaf&)> visit) const;
  bool visit_crossed(const Beam& beam, FunctionRef<bool(LeafId, const Leaf&)> visit) const;
  /// Parts of the R-tree, at least `least` where it is as wide, that together hold the leaves
  /// whose boxes, and all nodes around them, `enter` accepts.
  using Part = RTree<LeafId>::Subtree;
  std::vector<Part> parts_where(std::size_t least, FunctionRef<bool(const CellBox&)> enter) const;
  /// The leaves of a part whose boxes, and all nodes around them, `enter` accepts.
  void visit_where(const Part& part, FunctionRef<bool(const CellBox&)> enter,
                   FunctionRef<void(LeafId, const Leaf&)> visit) const;
  /// The leaves that a beam crosses, in no exact order, until they enter beyond the limit that
  /// `visit` answers with, as RTree::crossed_until.
  using VisitAlong = FunctionRef<double(const Leaf&, double enter)>;
  virtual void visit_along(const Beam& beam, VisitAlong visit) const;

  std::size_t leaf_count() const { return tree_.size(); }
  /// All leaf ids are below.
  virtual LeafId id_limit() const = 0;
  CellBox leaf_bounds() const { return tree_.bounds(); }
  RTreeStatistics tree_statistics() const { return tree_.statistics(); }
  virtual BytesInUse bytes_in_use() const = 0;
  std::optional<std::string> check() const;

  // --- Writing ---------------------------------------------------------------

  struct Ensured {
    LeafId id;
    CellMask created;
  };
  /// Makes the cells of `cells` exist in the leaf at `origin`, new ones with `value`.
  Ensured ensure(const Cell& origin, const CellMask& cells, Value value);
  /// The same for a leaf that exists; returns the cells that are new.
  CellMask add_missing(LeafId id, const CellMask& cells, Value value);
  /// Makes leaves that do not exist, each once, and sets their ids. Many at a time cost less.
  void add_leaves(std::span<MarkedLeaf> leaves, Value value);
  /// The cells of a leaf, and their values in the order of positions, to be changed.
  struct Content {
    CellMask cells;
    Value* values;
  };
  virtual Content content(LeafId id) = 0;
  /// Asks for the memory of content(id) ahead of time.
  virtual void prefetch(LeafId id) const = 0;
  /// Removes existing cells of a leaf; a leaf without cells goes, and its id with it.
  void remove(LeafId id, const Cell& origin, const CellMask& cells);

  virtual Stamp stamp(LeafId id) const = 0;
  virtual void set_stamp(LeafId id, Stamp stamp) = 0;
  /// Packs the nodes of the R-tree full, unless they are: less memory, less overlap.
  void repack();

 protected:
  LeafStore(const Options& options, std::int32_t edge);
  LeafStore(const LeafStore&) = default;

  const RTree<LeafId>& tree() const { return tree_; }
  CellBox leaf_box(const Cell& origin) const {
    return {.min = origin, .max = origin + Cell::Constant(edge())};
  }

 private:
  /// A new leaf without cells.
  virtual LeafId allocate(const Cell& origin) = 0;
  /// Frees a leaf without cells.
  virtual void release(LeafId id) = 0;
  /// Adds cells that the leaf does not have, with `value`.
  virtual void add_cells(LeafId id, const CellMask& cells, Value value) = 0;
  /// Takes cells that the leaf has.
  virtual void take_cells(LeafId id, const CellMask& cells) = 0;
  virtual std::optional<std::string> check_storage() const = 0;

  /// Enters new leaves in the R-tree.
  void enter(std::span<const MarkedLeaf> leaves);

  RTree<LeafId> tree_;
  std::size_t unpacked_ = 0;  ///< leaves that came or went since the tree was packed
};

}  // namespace rmap
