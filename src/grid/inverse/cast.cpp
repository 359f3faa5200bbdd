#include "grid/inverse/cast.hpp"

#include "grid/block_marks.hpp"
#include "grid/inverse/cast_kernel.hpp"
#include "grid/parallel.hpp"

#include <algorithm>

namespace rmap {

namespace {

// Fewer are not worth another thread.
constexpr std::size_t kLeastBlocks = 64;

// The cells of a block that are to be asked, and the leaves that they belong to.
struct Candidate {
  Cell origin;  ///< of the block
  CellMask asked;
  std::size_t first_leaf;  ///< in Candidates::leaves
  std::size_t leaves;
};

struct CandidateLeaf {
  LeafId id;
  BlockPosition position;  ///< of its lowest cell in the block
};

struct Candidates {
  std::vector<Candidate> blocks;
  std::vector<CandidateLeaf> leaves;
};

// The cells of a leaf that a crossing beam would change.
CellMask open_cells(const Leaf& leaf, const CellMask* hits, const UpdateRule& rule) {
  const CellMask existing = leaf.cells();
  const Value* const values = leaf.values();
  const CellMask left = hits == nullptr ? existing : existing.without(*hits);
  CellMask open = left;
  left.for_each_ranked(existing, [&](BlockPosition position, std::uint32_t rank) {
    if (rule.settled(values[rank])) open.reset(position);
  });
  return open;
}

// Calls use(id, leaf, cells to ask) for the leaves in view.
template <class Use>
void for_each_in_view(const LeafStore& store, const BeamIndex& index, const LeafMarks& hit,
                      const UpdateRule& rule, Use&& use) {
  const Cell origin_cell = index.beams().origin_cell;
  store.visit_where(
      [&](const CellBox& box) {
        return index.may_reach(box) || (index.has_cut_at_origin() && box.contains(origin_cell));
      },
      [&](LeafId id, const Leaf& leaf) {
        const CellMask open = open_cells(leaf, hit.find(id), rule);
        if (!open.none()) use(id, leaf, open);
        return true;
      });
}

Candidates blocks_in_view(const LeafStore& store, const BeamIndex& index, const LeafMarks& hit,
                          const UpdateRule& rule) {
  Candidates candidates;
  for_each_in_view(store, index, hit, rule, [&](LeafId id, const Leaf& leaf, const CellMask& open) {
    candidates.blocks.push_back({leaf.origin, open, candidates.leaves.size(), 1});
    candidates.leaves.push_back({id, 0});
  });
  return candidates;
}

// Leaves of one cell are asked together with the others of their block.
Candidates cells_in_view(const LeafStore& store, const BeamIndex& index, const LeafMarks& hit,
                         const UpdateRule& rule) {
  struct Found {
    LeafId id;
    Cell cell;
  };
  std::vector<Found> found;
  BlockMarks asked;
  for_each_in_view(store, index, hit, rule, [&](LeafId id, const Leaf& leaf, const CellMask&) {
    found.push_back({id, leaf.origin});
    asked.add(leaf.origin);
  });

  Candidates candidates;
  std::size_t first = 0;
  for (const BlockMarks::Block& block : asked.blocks()) {
    candidates.blocks.push_back({block.origin, block.cells, first, 0});
    first += block.cells.count();
  }
  candidates.leaves.resize(first);
  for (const Found& leaf : found) {
    Candidate& block = candidates.blocks[asked.place_of(block_origin(leaf.cell))];
    candidates.leaves[block.first_leaf + block.leaves++] = {leaf.id, block_position(leaf.cell)};
  }
  return candidates;
}

}  // namespace

std::vector<MarkedLeaf> cast(const LeafStore& store, const ScanBeams& beams, const BeamIndex& index,
                             const LeafMarks& hit, const UpdateRule& rule, int threads) {
  const bool has_blocks = store.edge() == kBlockEdge;
  const Candidates candidates =
      has_blocks ? blocks_in_view(store, index, hit, rule) : cells_in_view(store, index, hit, rule);
  const auto exactly = [&](std::uint32_t number, const Cell& cell) {
    return crosses(*beams.beam(number), cell);
  };
  const Cell origin_cell = index.beams().origin_cell;
  std::vector<std::vector<MarkedLeaf>> found(
      range_count(threads, candidates.blocks.size(), kLeastBlocks));
  for_each_range(
      threads, candidates.blocks.size(), kLeastBlocks,
      [&](std::size_t range, std::size_t begin, std::size_t end) {
        std::vector<MarkedLeaf>& marked = found[range];
        for (const Candidate& block : std::span(candidates.blocks).subspan(begin, end - begin)) {
          CellMask crossed = crossed_in_block(index.beams(), block.origin, block.asked, exactly);
          if (index.has_cut_at_origin() && block_origin(origin_cell) == block.origin) {
            crossed |= CellMask::single(block_position(origin_cell)) & block.asked;
          }
          if (crossed.none()) continue;
          for (const CandidateLeaf& leaf :
               std::span(candidates.leaves).subspan(block.first_leaf, block.leaves)) {
            if (has_blocks) {
              marked.push_back({leaf.id, block.origin, crossed});
            } else if (crossed.test(leaf.position)) {
              marked.push_back(
                  {leaf.id, block.origin + block_offset(leaf.position), CellMask::single(0)});
            }
          }
        }
      });
  for (std::size_t range = 1; range < found.size(); ++range) {
    found[0].insert(found[0].end(), found[range].begin(), found[range].end());
  }
  return std::move(found[0]);
}

}  // namespace rmap
