#include "io/atomic_file.hpp"
#include "io/octomap/tree_encoder.hpp"
#include "io/sorted_leaves.hpp"
#include "io/text.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/octomap_file.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {

namespace {

// Of a free cell with the value 0: OctoMap calls log-odds of 0 occupied. A quarter of a step, so
// that reading it rounds to 0 again.
constexpr float kFreeZero = -0.00025F;

bool wants_states_only(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  if (ending == ".bt") return true;
  if (ending == ".ot") return false;
  throw Error(ErrorKind::input, fmt::format("the ending of {} is {}, where .bt and .ot are allowed",
                                            file.string(), in_quotes(ending)));
}

float log_odds_of(Value value, bool occupied, bool states_only) {
  if (states_only) return occupied ? 1.0F : -1.0F;
  if (value == 0 && !occupied) return kFreeZero;
  return static_cast<float>(value / 1000.0);
}

void require_key(const std::filesystem::path& file, const Cell& cell) {
  if (cell.minCoeff() >= -octomap::kHalf && cell.maxCoeff() < octomap::kHalf) return;
  throw Error(ErrorKind::limit,
              fmt::format("cannot write {}: cell ({}, {}, {}) is beyond what OctoMap can hold: its "
                          "indices lie in {} to {}",
                          file.string(), cell.x(), cell.y(), cell.z(), -octomap::kHalf,
                          octomap::kHalf - 1));
}

}  // namespace

OctomapExport export_octomap(const Grid& grid, const std::filesystem::path& file) {
  const bool states_only = wants_states_only(file);
  const UpdateRule& rule = grid.rule();
  AtomicFile output(file);
  OctomapExport report;
  octomap::TreeEncoder encoder(states_only);
  const std::vector<Leaf> leaves = sorted_leaves(grid);
  std::vector<CellValue> cells;
  // From the last cell to the first, as the encoder wants them.
  for (auto leaf = leaves.rbegin(); leaf != leaves.rend(); ++leaf) {
    cells.clear();
    leaf->for_each([&](const Cell& cell, Value value) { cells.push_back({cell, value}); });
    for (auto entry = cells.rbegin(); entry != cells.rend(); ++entry) {
      const auto& [cell, value] = *entry;
      require_key(file, cell);
      const bool occupied = rule.occupied(value);
      const float log_odds = log_odds_of(value, occupied, states_only);
      encoder.add(cell, log_odds);
      ++(occupied ? report.occupied_cells : report.free_cells);
      if (states_only) {
        constexpr std::int32_t kBeyond = 40000;
        if (value != rule.clamped(occupied ? kBeyond : -kBeyond)) ++report.lost_values;
      } else if ((log_odds >= 0) != occupied) {
        ++report.changed_states;
      }
    }
  }
  const std::vector<std::byte> nodes = encoder.take_bytes();
  report.nodes = encoder.nodes();
  output.write(octomap::text_of({.states_only = states_only,
                                 .nodes = report.nodes,
                                 .resolution = grid.lattice().resolution()}));
  output.write(nodes);
  output.commit();
  return report;
}

}  // namespace rmap
