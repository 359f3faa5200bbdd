#include "grid/inverse/cast.hpp"

#include "grid/block_marks.hpp"
#include "grid/inverse/cast_kernel.hpp"
#include "grid/parallel.hpp"

#include <span>

namespace rmap {

namespace {

// Some parts take far longer than others.
constexpr std::size_t kRangesPerThread = 8;
constexpr std::size_t kPartsPerRange = 4;

// Without a branch for each value: whole vectors are looked at.
bool any_settled(std::span<const Value> values, const UpdateRule& rule) {
  bool any = false;
  for (const Value value : values) any |= rule.settled(value);
  return any;
}

// The cells of a leaf that a crossing beam would change.
CellMask open_cells(const Leaf& leaf, const CellMask* hits, const UpdateRule& rule) {
  const CellMask existing = leaf.cells();
  const Value* const values = leaf.values();
  const CellMask left = hits == nullptr ? existing : existing.without(*hits);
  if (!any_settled({values, existing.count()}, rule)) return left;
  CellMask open = left;
  left.for_each_ranked(existing, [&](BlockPosition position, std::uint32_t rank) {
    if (rule.settled(values[rank])) open.reset(position);
  });
  return open;
}

std::size_t ranges_for(int threads) {
  const auto count = static_cast<std::size_t>(thread_count(threads));
  return count == 1 ? 1 : kRangesPerThread * count;
}

}  // namespace

Cast::Cast(const LeafStore& store, const ScanBeams& beams, const BeamIndex& index,
           const UpdateRule& rule, int threads)
    : store_(store),
      beams_(beams),
      index_(index),
      rule_(rule),
      threads_(threads),
      ranges_(ranges_for(threads)) {
  const auto enter = [this](const CellBox& box) { return may_enter(box); };
  parts_ = store.parts_where(ranges_ == 1 ? 1 : kPartsPerRange * ranges_, enter);
}

void Cast::run(HitIn hit_in, Crossed crossed) const {
  if (store_.edge() == kBlockEdge) {
    run_by_block(hit_in, crossed);
  } else {
    run_by_cell(hit_in, crossed);
  }
}

bool Cast::may_enter(const CellBox& box) const {
  return index_.may_reach(box) ||
         (index_.has_cut_at_origin() && box.contains(index_.beams().origin_cell));
}

CellMask Cast::crossed_in(const Cell& block, const CellMask& asked) const {
  const Cell& origin_cell = index_.beams().origin_cell;
  CellMask crossed = crossed_in_block(
      index_.beams(), block, asked,
      [&](std::uint32_t number, const Cell& cell) { return crosses(*beams_.beam(number), cell); });
  if (index_.has_cut_at_origin() && block_origin(origin_cell) == block) {
    crossed |= CellMask::single(block_position(origin_cell)) & asked;
  }
  return crossed;
}

// use(range, id, leaf, cells that are to be asked) for the leaves that have some.
template <class Use>
void Cast::for_each_in_view(HitIn hit_in, const Use& use) const {
  for_each_range(
      static_cast<int>(ranges_), parts_.size(),
      [&](std::size_t range, std::size_t begin, std::size_t end) {
        for (const LeafStore::Part& part : std::span(parts_).subspan(begin, end - begin)) {
          store_.visit_where(
              part, [&](const CellBox& box) { return may_enter(box); },
              [&](LeafId id, const Leaf& leaf) {
                const CellMask open = open_cells(leaf, hit_in(range, id, leaf), rule_);
                if (!open.none()) use(range, id, leaf, open);
              });
        }
      });
}

void Cast::run_by_block(HitIn hit_in, Crossed crossed) const {
  for_each_in_view(hit_in,
                   [&](std::size_t range, LeafId id, const Leaf& leaf, const CellMask& open) {
                     const CellMask cells = crossed_in(leaf.origin, open);
                     if (!cells.none()) crossed(range, id, leaf.origin, cells);
                   });
}

// Leaves of one cell are asked together with the others of their block.
void Cast::run_by_cell(HitIn hit_in, Crossed crossed) const {
  struct Found {
    LeafId id;
    Cell cell;
  };
  std::vector<std::vector<Found>> found(ranges_);
  for_each_in_view(hit_in, [&](std::size_t range, LeafId id, const Leaf& leaf, const CellMask&) {
    found[range].push_back({id, leaf.origin});
  });
  BlockMarks asked;
  for (const auto& part : found) {
    for (const Found& leaf : part) asked.add(leaf.cell);
  }
  std::vector<CellMask> cells(asked.blocks().size());
  for_each_range(threads_, cells.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      cells[i] = crossed_in(asked.blocks()[i].origin, asked.blocks()[i].cells);
    }
  });
  for (std::size_t range = 0; range < ranges_; ++range) {
    for (const Found& leaf : found[range]) {
      if (cells[*asked.find(block_origin(leaf.cell))].test(block_position(leaf.cell))) {
        crossed(range, leaf.id, leaf.cell, CellMask::single(0));
      }
    }
  }
}

}  // namespace rmap
