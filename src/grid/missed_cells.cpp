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

MissedCells::MissedCells(const LeafStore& store, const UpdateRule& rule, const ScanBeams& beams,
                         const LeafMarks& hit)
    : store_(store), rule_(rule), beams_(beams), hit_(hit) {}

std::vector<MarkedLeaf> MissedCells::of(std::span<const BeamGroup> groups) const {
  std::vector<std::vector<MarkedLeaf>> parts;
  std::vector<std::uint32_t> followed;
  for (const BeamGroup& group : groups) {
    if (!casts_inversely(group, beams_.options())) {
      append_numbers(group, followed);
      continue;
    }
    BeamIndex index = index_for(beams_, group);
    index_beams(beams_, group, index);
    parts.push_back(of(index));
  }
  if (!followed.empty()) {
    parts.push_back(crossed_cells(store_, beams_, followed, hit_, threads()).marked());
  }
  if (parts.size() == 1) return std::move(parts.front());
  LeafMarks all(store_.id_limit());
  for (const auto& part : parts) {
    for (const MarkedLeaf& leaf : part) all.at(leaf.id, leaf.origin) |= leaf.cells;
  }
  return std::move(all).marked();
}

std::vector<MarkedLeaf> MissedCells::of(BeamIndex& index) const {
  index.sort(threads());
  return cast(store_, beams_, index, hit_, rule_, threads());
}

}  // namespace rmap
