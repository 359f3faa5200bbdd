#include "grid/missed_cells.hpp"

#include "grid/end_cells.hpp"
#include "grid/forward/crossed_cells.hpp"
#include "grid/inverse/cast.hpp"

namespace rmap {

namespace {

// For fewer beams from one place the index costs more than following them.
constexpr std::size_t kFewBeams = 128;

void append_numbers(const BeamGroup& group, std::vector<std::uint32_t>& numbers) {
  for (std::size_t i = 0; i < group.size; ++i) {
    numbers.push_back(group.numbers.empty() ? static_cast<std::uint32_t>(i) : group.numbers[i]);
  }
}

}  // namespace

bool casts_inversely(const BeamGroup& group, const Options& options) {
  switch (options.traversal) {
    case Traversal::inverse:
      return true;
    case Traversal::forward:
      return false;
    case Traversal::automatic:
      break;
  }
  return group.size >= kFewBeams;
}

std::vector<MarkedLeaf> missed_cells(const LeafStore& store, const UpdateRule& rule,
                                     const ScanBeams& beams, std::span<const BeamGroup> groups,
                                     const LeafMarks& hit) {
  const int threads = beams.options().threads;
  LeafMarks missed(store.id_limit());
  std::vector<std::uint32_t> followed;
  for (const BeamGroup& group : groups) {
    if (!casts_inversely(group, beams.options())) {
      append_numbers(group, followed);
      continue;
    }
    BeamIndex index = index_for(beams, group);
    index_beams(beams, group, index);
    index.sort(threads);
    const Cast cast(store, beams, index, rule, threads);
    std::vector<std::vector<MarkedLeaf>> parts(cast.ranges());
    cast.run([&](std::size_t, LeafId id, const Leaf&) { return hit.find(id); },
             [&](std::size_t range, LeafId id, const Cell& origin, const CellMask& cells) {
               parts[range].push_back({id, origin, cells});
             });
    for (const auto& part : parts) {
      for (const MarkedLeaf& leaf : part) missed.at(leaf.id, leaf.origin) |= leaf.cells;
    }
  }
  if (!followed.empty()) missed.add(crossed_cells(store, beams, followed, hit, threads));
  return std::move(missed).marked();
}

}  // namespace rmap
