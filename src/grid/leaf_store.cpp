#include "grid/leaf_store.hpp"

#include "grid/block_store.hpp"
#include "grid/cell_store.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

namespace rmap {

namespace {

// Hands leaves on a few places later, so that their content is on its way from memory while
// others are worked on.
template <class Use>
class Lookahead {
 public:
  Lookahead(const LeafStore& store, Use use) : store_(store), use_(std::move(use)) {}

  bool add(const CellBox& box, LeafId id) {
    store_.prefetch(id);
    const Waiting leaf = std::exchange(waiting_[next_ % kAhead], {box.min, id});
    return ++next_ <= kAhead || use_leaf(leaf);
  }
  /// Those that still wait.
  bool finish() {
    for (std::size_t i = next_ < kAhead ? 0 : next_ - kAhead; i < next_; ++i) {
      if (!use_leaf(waiting_[i % kAhead])) return false;
    }
    return true;
  }

 private:
  static constexpr std::size_t kAhead = 4;
  struct Waiting {
    Cell origin = Cell::Zero();
    LeafId id = 0;
  };

  bool use_leaf(const Waiting& leaf) { return use_(leaf.id, store_.leaf(leaf.id, leaf.origin)); }

  const LeafStore& store_;
  Use use_;
  std::array<Waiting, kAhead> waiting_{};
  std::size_t next_ = 0;
};

}  // namespace

std::unique_ptr<LeafStore> LeafStore::make(const Options& options) {
  if (options.layout == Layout::cells) return std::make_unique<CellStore>(options);
  return std::make_unique<BlockStore>(options);
}

LeafStore::LeafStore(const Options& options, std::int32_t edge)
    : tree_({.max_branches = options.max_branches, .split = options.split, .leaf_edge = edge}) {}

bool LeafStore::visit(const CellBox& region, FunctionRef<bool(LeafId, const Leaf&)> visit) const {
  Lookahead ahead(*this, visit);
  return tree_.overlapping(region, [&](const CellBox& box, LeafId id) {
    return ahead.add(box, id);
  }) && ahead.finish();
}

bool LeafStore::visit_crossed(const Beam& beam,
                              FunctionRef<bool(LeafId, const Leaf&)> visit) const {
  return tree_.crossed_by(
      beam, [&](const CellBox& box, LeafId id) { return visit(id, leaf(id, box.min)); });
}

std::vector<LeafStore::Part> LeafStore::parts_where(std::size_t least,
                                                    FunctionRef<bool(const CellBox&)> enter) const {
  return tree_.subtrees(least, enter);
}

void LeafStore::visit_where(const Part& part, FunctionRef<bool(const CellBox&)> enter,
                            FunctionRef<void(LeafId, const Leaf&)> visit) const {
  tree_.descend(part, enter, [&](const CellBox& box, LeafId id) { visit(id, leaf(id, box.min)); });
}

void LeafStore::visit_along(const Beam& beam, VisitAlong visit) const {
  tree_.crossed_until(beam, [&](const CellBox& box, LeafId id, double enter) {
    return visit(leaf(id, box.min), enter);
  });
}

LeafStore::Ensured LeafStore::ensure(const Cell& origin, const CellMask& cells, Value value) {
  if (const auto id = find(origin)) return {*id, add_missing(*id, cells, value)};
  MarkedLeaf leaf{0, origin, cells};
  add_leaves({&leaf, 1}, value);
  return {leaf.id, cells};
}

CellMask LeafStore::add_missing(LeafId id, const CellMask& cells, Value value) {
  const CellMask missing = cells.without(content(id).cells);
  if (!missing.none()) add_cells(id, missing, value);
  return missing;
}

void LeafStore::add_leaves(std::span<MarkedLeaf> leaves, Value value) {
  for (MarkedLeaf& leaf : leaves) leaf.id = allocate(leaf.origin);
  enter(leaves);
  for (const MarkedLeaf& leaf : leaves) add_cells(leaf.id, leaf.cells, value);
}

// Packing the tree anew as soon as more than half of its leaves came since it was packed costs
// less than what it saves: entering a leaf one by one takes longer than packing it, and leaves
// nodes behind that are half full and overlap.
void LeafStore::enter(std::span<const MarkedLeaf> leaves) {
  unpacked_ += leaves.size();
  if (2 * unpacked_ <= tree_.size() + leaves.size()) {
    for (const MarkedLeaf& leaf : leaves) tree_.insert(leaf_box(leaf.origin), leaf.id);
    return;
  }
  std::vector<RTree<LeafId>::Item> items;
  items.reserve(tree_.size() + leaves.size());
  tree_.for_each([&](const CellBox& box, LeafId id) {
    items.push_back({box, id});
    return true;
  });
  for (const MarkedLeaf& leaf : leaves) items.push_back({leaf_box(leaf.origin), leaf.id});
  tree_ = RTree<LeafId>::bulk_load(items, tree_.options());
  unpacked_ = 0;
}

void LeafStore::repack() {
  if (unpacked_ > 0) tree_.repack();
  unpacked_ = 0;
}

void LeafStore::remove(LeafId id, const Cell& origin, const CellMask& cells) {
  const bool last = content(id).cells == cells;
  take_cells(id, cells);
  if (last) {
    release(id);
    tree_.erase(leaf_box(origin));
    ++unpacked_;
  }
}

std::optional<std::string> LeafStore::check() const {
  if (auto broken = tree_.check()) return "the R-tree is broken: " + *broken;
  std::optional<std::string> broken;
  visit(all_cells(), [&](LeafId id, const Leaf& found) {
    if (id >= id_limit()) {
      broken = fmt::format("leaf number {} is beyond {}", id, id_limit());
    } else if (found.cells().none()) {
      broken = fmt::format("the leaf at ({}, {}, {}) holds no cell", found.origin.x(),
                           found.origin.y(), found.origin.z());
    } else if (found.origin != origin_of(found.origin)) {
      broken = fmt::format("the leaf at ({}, {}, {}) is not aligned to {} cells", found.origin.x(),
                           found.origin.y(), found.origin.z(), edge());
    }
    return !broken.has_value();
  });
  return broken ? broken : check_storage();
}

}  // namespace rmap
