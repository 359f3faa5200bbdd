#include "io/memory.hpp"
#include "io/octomap/block_gatherer.hpp"
#include "io/octomap/leaves.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/octomap_file.hpp>

namespace rmap {

namespace {

using octomap::Leaves;

OctomapInfo info_of(const Leaves& leaves) {
  const octomap::Header& header = leaves.header();
  OctomapInfo info{.id = header.id,
                   .states_only = header.states_only,
                   .colors = header.colors() && !header.states_only,
                   .resolution = header.resolution,
                   .nodes = header.nodes};
  leaves.visit([&](const octomap::Leaf& leaf) {
    const bool first = info.occupied_leaves + info.free_leaves == 0;
    info.bounds = first ? leaf.box() : united(info.bounds, leaf.box());
    info.min_log_odds = first ? leaf.log_odds : std::min(info.min_log_odds, leaf.log_odds);
    info.max_log_odds = first ? leaf.log_odds : std::max(info.max_log_odds, leaf.log_odds);
    if (leaf.occupied) {
      info.occupied_bounds =
          info.occupied_leaves == 0 ? leaf.box() : united(info.occupied_bounds, leaf.box());
    }
    ++(leaf.occupied ? info.occupied_leaves : info.free_leaves);
    (leaf.occupied ? info.occupied_cells : info.free_cells) += leaf.cells();
  });
  return info;
}

// Before any of them takes memory.
void require_limit(const Leaves& leaves, std::uint64_t cells, std::uint64_t max_cells,
                   std::string_view which) {
  if (cells <= max_cells) return;
  throw Error(ErrorKind::limit,
              fmt::format("{} has {} {}cells when its large leaves are expanded, and at most {} "
                          "are allowed: raise the limit, max_cells (--max-cells), to take them",
                          leaves.file().string(), cells, which, max_cells));
}

OctomapCells occupied_cells(const Leaves& leaves, const OctomapReadOptions& options) {
  const OctomapInfo info = info_of(leaves);
  require_limit(leaves, info.occupied_cells, options.max_cells, "occupied ");
  OctomapCells cells{.resolution = info.resolution,
                     .occupied = {},
                     .occupied_leaves = info.occupied_leaves,
                     .free_leaves = info.free_leaves};
  cells.occupied.reserve(static_cast<std::size_t>(info.occupied_cells));
  leaves.visit([&](const octomap::Leaf& leaf) {
    if (!leaf.occupied) return;
    octomap::for_each_cell(leaf, [&](const Cell& cell) { cells.occupied.push_back(cell); });
  });
  return cells;
}

/// The values that leaves get in a grid.
class LeafValues {
 public:
  LeafValues(const UpdateRule& rule, bool states_only) : rule_(rule), states_only_(states_only) {}

  Value value_of(const octomap::Leaf& leaf) {
    // Beyond all values: the limits, which are what OctoMap gives to states, stop it.
    constexpr double kBeyond = 40000;
    const double steps = states_only_ ? (leaf.occupied ? kBeyond : -kBeyond)
                                      : 1000 * static_cast<double>(leaf.log_odds);
    const auto nearest =
        static_cast<std::int32_t>(std::round(std::clamp(steps, -kBeyond, kBeyond)));
    const Value value = rule_.clamped(nearest);
    if (!states_only_ && value != nearest) ++clamped;
    if (rule_.occupied(value) == leaf.occupied) return value;
    // OctoMap takes its threshold itself for occupied, where it is free here.
    const Value next = rule_.clamped(nearest + (leaf.occupied ? 1 : -1));
    if (rule_.occupied(next) == leaf.occupied) return next;
    ++changed;
    return value;
  }

  std::uint64_t clamped = 0;
  std::uint64_t changed = 0;

 private:
  const UpdateRule& rule_;
  bool states_only_;
};

Options options_for(const Leaves& leaves, Options options) {
  const double resolution = leaves.header().resolution;
  if (options.resolution != 0 && options.resolution != resolution) {
    throw Error(ErrorKind::input,
                fmt::format("{} has a resolution of {} m, not {} m", leaves.file().string(),
                            resolution, options.resolution));
  }
  options.resolution = resolution;
  return options;
}

OctomapImport imported(const Leaves& leaves, const OctomapImportOptions& options) {
  OctomapImport import{.grid = Grid(options_for(leaves, options.map)), .file = info_of(leaves)};
  require_limit(leaves,
                import.file.occupied_cells + (options.keep_free ? import.file.free_cells : 0),
                options.max_cells, options.keep_free ? "" : "occupied ");
  octomap::BlockGatherer gatherer(import.grid);
  LeafValues values(import.grid.rule(), leaves.header().states_only);
  leaves.visit([&](const octomap::Leaf& leaf) {
    if (!leaf.occupied && !options.keep_free) {
      ++import.dropped_free_leaves;
      return;
    }
    gatherer.add(leaf, values.value_of(leaf));
  });
  gatherer.flush();
  import.clamped_leaves = values.clamped;
  import.changed_leaves = values.changed;
  import.grid.restore(History::first_hit, {});
  import.grid.repack();
  return import;
}

}  // namespace

OctomapInfo read_octomap_info(const std::filesystem::path& file) {
  return with_memory_for(file, [&] { return info_of(Leaves(file)); });
}

OctomapCells read_octomap(const std::filesystem::path& file, const OctomapReadOptions& options) {
  return with_memory_for(file, [&] { return occupied_cells(Leaves(file), options); });
}

OctomapImport import_octomap(const std::filesystem::path& file,
                             const OctomapImportOptions& options) {
  return with_memory_for(file, [&] { return imported(Leaves(file), options); });
}

}  // namespace rmap
