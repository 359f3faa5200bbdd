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
    : store_(store), beams_(beams), index_(index), rule_(rule), ranges_(ranges_for(threads)) {
  const auto enter = [this](const CellBox& box) { return may_enter(box); };
  parts_ = store.parts_where(ranges_ == 1 ? 1 : kPartsPerRange * ranges_, enter);
}

void Cast::run(HitIn hit_in, Crossed crossed) const {
  for_each_range(static_cast<int>(ranges_), parts_.size(),
                 [&](std::size_t range, std::size_t begin, std::size_t end) {
                   const auto parts = std::span(parts_).subspan(begin, end - begin);
                   if (store_.edge() == 1) return run_by_cell(range, parts, hit_in, crossed);
                   for (const auto& part : parts) run_by_block(range, part, hit_in, crossed);
                 });
}

bool Cast::may_enter(const CellBox& box) const {
  if (index_.may_reach(box)) return true;
  // Beams that are shorter than a direction can tell end in the origin's cell or beside it.
  const Cell& origin = index_.beams().origin_cell;
  return (origin.array() >= box.min.array() - 1).all() && (origin.array() <= box.max.array()).all();
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

void Cast::run_by_block(std::size_t range, const LeafStore::Part& part, HitIn hit_in,
                        Crossed crossed) const {
  store_.visit_where(
      part, [&](const CellBox& box) { return may_enter(box); },
      [&](LeafId id, const Leaf& leaf) {
        const CellMask open = open_cells(leaf, hit_in(range, id, leaf), rule_);
        if (open.none()) return;
        const CellMask cells = crossed_in(leaf.origin, open);
        if (!cells.none()) crossed(range, id, leaf.origin, cells);
      });
}

// Leaves of one cell are asked together with the others of their block. Only nodes are culled:
// to ask of a single cell whether it is in view takes as long as to cast it.
void Cast::run_by_cell(std::size_t range, std::span<const LeafStore::Part> parts, HitIn hit_in,
                       Crossed crossed) const {
  struct Found {
    LeafId id;
    std::uint32_t block;  ///< its place in `asked`
    Cell cell;
  };
  std::vector<Found> found;
  BlockMarks asked;
  for (const LeafStore::Part& part : parts) {
    store_.visit_where(
        part, [&](const CellBox& box) { return box == box_of(box.min) || may_enter(box); },
        [&](LeafId id, const Leaf& leaf) {
          if (hit_in(range, id, leaf) != nullptr || rule_.settled(*leaf.values())) return;
          found.push_back({id, asked.add(leaf.origin), leaf.origin});
        });
  }
  std::vector<CellMask> cells;
  cells.reserve(asked.blocks().size());
  for (const BlockMarks::Block& block : asked.blocks()) {
    cells.push_back(crossed_in(block.origin, block.cells));
  }
  for (const Found& leaf : found) {
    if (cells[leaf.block].test(block_position(leaf.cell))) {
      crossed(range, leaf.id, leaf.cell, CellMask::single(0));
    }
  }
}

}  // namespace rmap
