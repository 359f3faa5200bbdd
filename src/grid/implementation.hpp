#pragma once

#include "grid/beam_groups.hpp"
#include "grid/block_marks.hpp"
#include "grid/change_log.hpp"
#include "grid/inverse/beam_index.hpp"
#include "grid/leaf_marks.hpp"
#include "grid/leaf_store.hpp"
#include "grid/parallel.hpp"
#include "grid/scan_beams.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include <rmap/grid.hpp>

namespace rmap {

/// What is inside a grid. The verbs that change it have files of their own:
/// insert.cpp, change.cpp, merge.cpp.
class Grid::Implementation {
 public:
  explicit Implementation(const Options& grid_options);
  Implementation(const Implementation& other);
  Implementation& operator=(const Implementation&) = delete;

  /// Raises the revision. Every mutation starts with it.
  void begin_mutation();
  /// Notes that cells appeared in a leaf.
  void count_new_cells(std::uint32_t cells);
  /// The same of cells that a scan made with `value`; returns how many.
  std::uint32_t note_new_cells(LeafId id, const Cell& origin, const CellMask& cells, Value value);

  /// Replaces the value of each cell in `cells`, all of which the leaf has, by
  /// change(cell, value); notes what changed and returns how many values did.
  /// `created`: cells that did not exist before this mutation.
  template <class Change>
  std::uint64_t update(LeafId id, const Cell& origin, const CellMask& cells,
                       const CellMask& created, Change&& change);

  /// Makes cells exist, new ones with the prior, and returns the leaves that hold them.
  struct Ensured {
    std::vector<MarkedLeaf> leaves;
    std::uint64_t new_cells = 0;
  };
  Ensured ensure(const BlockMarks& cells);
  /// Makes cells of existing leaves exist, new ones with `value`; note(id, origin, new cells).
  template <class Note>
  void add_missing(std::span<const MarkedLeaf> leaves, Value value, const Note& note);
  /// Makes the leaves of cells in blocks, none of which exists, with `value`; notes as above.
  /// They are sorted first: the R-tree grows alike whatever the order of the points.
  template <class Note>
  std::vector<MarkedLeaf> enter_missing(std::vector<BlockMarks::Block> blocks, Value value,
                                        const Note& note);

  /// What the beams of a scan did.
  struct Updates {
    std::uint64_t new_cells = 0;
    std::uint64_t hits = 0;
    std::uint64_t misses = 0;
  };
  /// Inserts a scan whose beams are all in `index`, sorted, in one descent of the R-tree.
  Updates insert_inversely(const ScanBeams& beams, const BeamIndex& index, const BlockMarks& ends);
  /// Inserts any scan: makes its end cells, hits them, then finds and clears what it missed.
  Updates insert_by_marks(const ScanBeams& beams, std::span<const BeamGroup> groups,
                          const BlockMarks& ends);
  /// Replaces the value of each marked cell by change(value), with the threads of the options;
  /// returns how many values changed.
  template <class Change>
  std::uint64_t update_all(std::span<const MarkedLeaf> leaves, const Change& change);

  /// Makes the cells of leaves, each leaf once, hold values.
  struct LeafValues {
    Cell origin;
    CellMask cells;
    const Value* values;  ///< in the order of positions
  };
  void write(std::span<const LeafValues> leaves);

  /// Removes the cells of `region` for which drop(value) holds; returns how many.
  std::size_t remove_cells(const CellBox& region, FunctionRef<bool(Value)> drop);

  Options options;
  Lattice lattice;
  UpdateRule rule;
  std::unique_ptr<LeafStore> store;
  ChangeLog log;
  std::size_t cell_count = 0;
  std::vector<Pose> scan_poses;
  History history = History::complete;
};

template <class Note>
void Grid::Implementation::add_missing(std::span<const MarkedLeaf> leaves, Value value,
                                       const Note& note) {
  constexpr std::size_t kAhead = 6;  // on their way from memory while others are worked on
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (i + kAhead < leaves.size()) store->prefetch(leaves[i + kAhead].id);
    const auto& [id, origin, cells] = leaves[i];
    note(id, origin, store->add_missing(id, cells, value));
  }
}

template <class Note>
std::vector<MarkedLeaf> Grid::Implementation::enter_missing(std::vector<BlockMarks::Block> blocks,
                                                            Value value, const Note& note) {
  std::sort(blocks.begin(), blocks.end(),
            [](const auto& a, const auto& b) { return morton_less(a.origin, b.origin); });
  std::vector<MarkedLeaf> leaves;
  for (const BlockMarks::Block& block : blocks) {
    store->for_each_leaf_of(block.origin, block.cells, [&](const Cell& origin, const CellMask& c) {
      assert(!store->find(origin));
      leaves.push_back({0, origin, c});
    });
  }
  store->add_leaves(leaves, value);
  for (const MarkedLeaf& leaf : leaves) note(leaf.id, leaf.origin, leaf.cells);
  return leaves;
}

template <class Change>
std::uint64_t Grid::Implementation::update_all(std::span<const MarkedLeaf> leaves,
                                               const Change& change) {
  constexpr std::size_t kLeastLeaves = 256;  // fewer are not worth another thread
  // The journal of flips is one list.
  const int threads = log.tracks_flips() ? 1 : options.threads;
  std::vector<std::uint64_t> changed(range_count(threads, leaves.size(), kLeastLeaves), 0);
  for_each_range(threads, leaves.size(), kLeastLeaves,
                 [&](std::size_t range, std::size_t begin, std::size_t end) {
                   std::uint64_t count = 0;
                   for (const MarkedLeaf& leaf : leaves.subspan(begin, end - begin)) {
                     count += update(leaf.id, leaf.origin, leaf.cells, {},
                                     [&](const Cell&, Value value) { return change(value); });
                   }
                   changed[range] = count;
                 });
  return std::accumulate(changed.begin(), changed.end(), std::uint64_t{0});
}

template <class Change>
std::uint64_t Grid::Implementation::update(LeafId id, const Cell& origin, const CellMask& cells,
                                           const CellMask& created, Change&& change) {
  const auto [existing, values] = store->content(id);
  const bool notes_flips = log.tracks_flips();
  std::uint64_t changed = 0;
  cells.for_each_ranked(existing, [&, first = values](BlockPosition position, std::uint32_t rank) {
    Value& value = first[rank];
    const Cell cell = origin + block_offset(position);
    const Value before = value;
    const bool is_new = created.test(position);
    value = change(cell, before);
    if (value != before || is_new) ++changed;
    if (notes_flips && rule.occupied(value) != (!is_new && rule.occupied(before))) {
      log.flipped(cell);
    }
  });
  if (changed > 0) store->set_stamp(id, log.stamp());
  return changed;
}

}  // namespace rmap
