#include "grid/implementation.hpp"
#include "grid/inverse/cast.hpp"

#include <algorithm>

namespace rmap {

namespace {

// An end cell's leaf that was there before the scan.
struct Met {
  std::uint32_t block;     ///< place in the end cells' blocks
  BlockPosition position;  ///< of the leaf's lowest cell in the block
};

struct Grown {
  LeafId id;
  std::uint32_t block;
};

// What one range of the cast found and did.
struct Share {
  std::vector<Met> met;
  std::vector<Grown> grown;  ///< leaves that lack end cells
  std::uint64_t hits = 0;
  std::uint64_t misses = 0;
};

// The end cells of a scan, and which of their leaves a cast met.
class EndLeaves {
 public:
  EndLeaves(const LeafStore& store, const BlockMarks& ends) : store_(store), ends_(ends) {}

  /// The end cells in a leaf, and where they stand; null when there are none.
  const CellMask* find(const Leaf& leaf, Met& met) const {
    const auto block = ends_.find(block_origin(leaf.origin));
    if (!block) return nullptr;
    met = {*block, block_position(leaf.origin)};
    if (leaf.edge == kBlockEdge) return &cells(*block);
    static constexpr CellMask kOneCell = CellMask::single(0);
    return cells(*block).test(met.position) ? &kOneCell : nullptr;
  }
  const CellMask& cells(std::uint32_t block) const { return ends_.blocks()[block].cells; }

  /// use(origin, cells) for the leaves that were not met.
  template <class Use>
  void for_each_other(std::span<const Share> shares, const Use& use) const {
    std::vector<CellMask> left;
    left.reserve(ends_.blocks().size());
    for (const BlockMarks::Block& block : ends_.blocks()) left.push_back(block.cells);
    for (const Share& share : shares) {
      for (const Met& met : share.met) {
        if (store_.edge() == kBlockEdge) {
          left[met.block] = {};
        } else {
          left[met.block].reset(met.position);
        }
      }
    }
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (!left[i].none()) store_.for_each_leaf_of(ends_.blocks()[i].origin, left[i], use);
    }
  }

 private:
  const LeafStore& store_;
  const BlockMarks& ends_;
};

}  // namespace

Grid::Implementation::Updates Grid::Implementation::insert_inversely(const ScanBeams& beams,
                                                                     const BeamIndex& index,
                                                                     const BlockMarks& ends) {
  const auto hit = [&](const Cell&, Value value) { return rule.hit(value); };
  const auto miss = [&](const Cell&, Value value) { return rule.miss(value); };
  const EndLeaves end_leaves(*store, ends);
  // The journal of flips is one list.
  const Cast cast(*store, beams, index, rule, log.tracks_flips() ? 1 : options.threads);
  std::vector<Share> shares(cast.ranges());
  // Hits first. Cells that are to come need no cast: the scan hits them.
  cast.run(
      [&](std::size_t range, LeafId id, const Leaf& leaf) {
        Met met;
        const CellMask* const cells = end_leaves.find(leaf, met);
        if (cells == nullptr) return cells;
        Share& share = shares[range];
        share.met.push_back(met);
        const CellMask here = leaf.cells() & *cells;
        share.hits += update(id, leaf.origin, here, {}, hit);
        if (here != *cells) share.grown.push_back({id, met.block});
        return cells;
      },
      [&](std::size_t range, LeafId id, const Cell& origin, const CellMask& cells) {
        shares[range].misses += update(id, origin, cells, {}, miss);
      });

  Updates updates;
  const Value first_hit = rule.hit(rule.prior());
  const auto note_new = [&](LeafId id, const Cell& origin, const CellMask& cells) {
    const std::uint32_t count = cells.count();
    store->set_stamp(id, log.stamp());
    count_new_cells(count);
    updates.new_cells += count;
    if (first_hit != rule.prior()) updates.hits += count;
    if (!log.tracks_flips() || !rule.occupied(first_hit)) return;
    cells.for_each([&](BlockPosition at) { log.flipped(origin + block_offset(at)); });
  };
  for (const Share& share : shares) {
    updates.hits += share.hits;
    updates.misses += share.misses;
    for (const Grown& leaf : share.grown) {
      note_new(leaf.id, ends.blocks()[leaf.block].origin,
               store->add_missing(leaf.id, end_leaves.cells(leaf.block), first_hit));
    }
  }
  std::vector<MarkedLeaf> missing;
  end_leaves.for_each_other(shares, [&](const Cell& origin, const CellMask& cells) {
    if (const auto id = store->find(origin)) {
      // Out of view: beams without a direction end there.
      const CellMask created = store->add_missing(*id, cells, first_hit);
      updates.hits += update(*id, origin, cells.without(created), {}, hit);
      if (!created.none()) note_new(*id, origin, created);
    } else {
      missing.push_back({0, origin, cells});
    }
  });
  enter_missing(missing, first_hit);
  for (const MarkedLeaf& leaf : missing) note_new(leaf.id, leaf.origin, leaf.cells);
  return updates;
}

}  // namespace rmap
