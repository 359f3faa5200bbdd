#include "grid/end_leaves.hpp"
#include "grid/implementation.hpp"
#include "grid/inverse/cast.hpp"

#include <vector>

namespace rmap {

namespace {

// What one range of the cast found and did.
struct Share {
  std::vector<EndLeaves::Met> met;
  std::vector<MarkedLeaf> grown;  ///< leaves that lack some of these end cells
  std::uint64_t hits = 0;
  std::uint64_t misses = 0;
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
        EndLeaves::Met met;
        const CellMask* const cells = end_leaves.find(leaf, met);
        if (cells == nullptr) return cells;
        Share& share = shares[range];
        share.met.push_back(met);
        const CellMask here = leaf.cells() & *cells;
        share.hits += update(id, leaf.origin, here, {}, hit);
        if (here != *cells) share.grown.push_back({id, leaf.origin, *cells});
        return cells;
      },
      [&](std::size_t range, LeafId id, const Cell& origin, const CellMask& cells) {
        shares[range].misses += update(id, origin, cells, {}, miss);
      });

  Updates updates;
  const Value first_hit = rule.hit(rule.prior());
  const auto note = [&](LeafId id, const Cell& origin, const CellMask& created) {
    const std::uint32_t count = note_new_cells(id, origin, created, first_hit);
    updates.new_cells += count;
    updates.hits += first_hit != rule.prior() ? count : 0;
  };
  EndLeaves::Rest rest(end_leaves);
  for (const Share& share : shares) {
    updates.hits += share.hits;
    updates.misses += share.misses;
    add_missing(share.grown, first_hit, note);
    rest.take(share.met);
  }
  // Leaves that are there are in view, and were met.
  enter_missing(rest.blocks(), first_hit, note);
  return updates;
}

}  // namespace rmap
