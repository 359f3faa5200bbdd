#pragma once

#include "evaluation/json.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include <rmap/cell.hpp>

namespace rmap::evaluation {

/// What the single pass costs: the misses before a cell's first hit, which implicit free space
/// loses, leave cells occupied that a grid which models free space calls free.
struct HistoryRow {
  std::string sequence = {};
  double resolution = 0;
  std::size_t scans = 0;
  std::uint64_t first_hit_occupied = 0;
  std::uint64_t complete_occupied = 0;
  std::uint64_t false_cells = 0;  ///< occupied with first-hit history, not with complete
  std::uint64_t lost_cells = 0;   ///< the other way

  /// Against OctoMap, where the program has it.
  struct Octomap {
    std::uint64_t occupied = 0;
    std::uint64_t only_octomap = 0;   ///< occupied there, not with complete history
    std::uint64_t only_complete = 0;  ///< the other way
    std::uint64_t first_hit_false = 0;
  };
  std::optional<Octomap> octomap = {};

  /// Percent of the occupied cells of the complete history.
  double false_percent() const;
};

Json to_json(const HistoryRow& row);

/// Occupied cells in Morton order; `octomap` is null where there is none.
HistoryRow compare_histories(std::span<const Cell> first_hit, std::span<const Cell> complete,
                             const std::vector<Cell>* octomap);

}  // namespace rmap::evaluation
