#include "grid/forward/crossed_cells.hpp"

#include "grid/parallel.hpp"

namespace rmap {

namespace {

void mark_crossed(const LeafStore& store, const Beam& beam, const LeafMarks& hit,
                  LeafMarks& crossed) {
  store.visit_crossed(beam, [&](LeafId id, const Leaf& leaf) {
    CellMask& marks = crossed.at(id, leaf.origin);
    CellMask left = leaf.cells().without(marks);
    if (const CellMask* hits = hit.find(id)) left = left.without(*hits);
    if (left.none()) return true;
    CellMask walked;
    for (BeamWalk walk(beam, leaf.box()); walk.more(); walk.advance()) {
      walked.set(store.position_of(walk.cell()));
    }
    marks |= walked & left;
    return true;
  });
}

}  // namespace

LeafMarks crossed_cells(const LeafStore& store, const ScanBeams& beams,
                        std::span<const std::uint32_t> numbers, const LeafMarks& hit, int threads) {
  std::vector<LeafMarks> found(range_count(threads, numbers.size()), LeafMarks(store.id_limit()));
  for_each_range(threads, numbers.size(),
                 [&](std::size_t range, std::size_t begin, std::size_t end) {
                   for (const std::uint32_t number : numbers.subspan(begin, end - begin)) {
                     if (const auto beam = beams.beam(number))
                       mark_crossed(store, *beam, hit, found[range]);
                   }
                 });
  for (std::size_t range = 1; range < found.size(); ++range) found[0].add(found[range]);
  return std::move(found[0]);
}

}  // namespace rmap
