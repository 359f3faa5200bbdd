#include "evaluation/history_experiment.hpp"

#include <algorithm>
#include <iterator>
#include <vector>

namespace rmap::evaluation {

namespace {

// How many cells of `a` are none of `b`; both in Morton order.
std::uint64_t missing(std::span<const Cell> a, std::span<const Cell> b) {
  std::vector<Cell> cells;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(cells),
                      morton_less);
  return cells.size();
}

}  // namespace

double HistoryRow::false_percent() const {
  return complete_occupied == 0
             ? 0
             : 100 * static_cast<double>(false_cells) / static_cast<double>(complete_occupied);
}

Json to_json(const HistoryRow& row) {
  Json json{{"sequence", row.sequence},
            {"resolution_m", row.resolution},
            {"scans", row.scans},
            {"first_hit_occupied", row.first_hit_occupied},
            {"complete_occupied", row.complete_occupied},
            {"false_cells", row.false_cells},
            {"lost_cells", row.lost_cells},
            {"false_percent", row.false_percent()}};
  const auto with = [&](const char* key, std::uint64_t HistoryRow::Octomap::*field) {
    json[key] = row.octomap ? Json((*row.octomap).*field) : Json(nullptr);
  };
  with("octomap_occupied", &HistoryRow::Octomap::occupied);
  with("only_octomap", &HistoryRow::Octomap::only_octomap);
  with("only_complete", &HistoryRow::Octomap::only_complete);
  with("first_hit_not_octomap", &HistoryRow::Octomap::first_hit_false);
  return json;
}

HistoryRow compare_histories(std::span<const Cell> first_hit, std::span<const Cell> complete,
                             const std::vector<Cell>* octomap) {
  HistoryRow row{.first_hit_occupied = first_hit.size(),
                 .complete_occupied = complete.size(),
                 .false_cells = missing(first_hit, complete),
                 .lost_cells = missing(complete, first_hit)};
  if (octomap != nullptr) {
    row.octomap = HistoryRow::Octomap{.occupied = octomap->size(),
                                      .only_octomap = missing(*octomap, complete),
                                      .only_complete = missing(complete, *octomap),
                                      .first_hit_false = missing(first_hit, *octomap)};
  }
  return row;
}

}  // namespace rmap::evaluation
