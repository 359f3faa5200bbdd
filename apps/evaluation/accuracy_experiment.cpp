#include "evaluation/accuracy_experiment.hpp"

#include "evaluation/map_under_test.hpp"
#include "evaluation/seen_cells.hpp"

#include <array>

namespace rmap::evaluation {

namespace {

constexpr std::size_t kEvery = 5;
constexpr std::size_t kFewestJudged = 6;
constexpr std::array kThresholds{0.9, 0.5};

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0 : 100 * static_cast<double>(part) / static_cast<double>(whole);
}

bool held_out(std::size_t index, std::size_t scans) {
  return scans < kEvery ? index + 1 == scans : index % kEvery == kEvery - 1;
}

struct Contender {
  std::string name;
  std::unique_ptr<MapUnderTest> map;  // null: holds nothing
};

std::vector<Contender> contenders(double resolution) {
  const Options options{.resolution = resolution};
  std::vector<Contender> all;
  all.push_back({kEmptyMap, nullptr});
  all.push_back({kFirstHit, std::make_unique<RmapMap>(options, History::first_hit)});
  all.push_back({kComplete, std::make_unique<RmapMap>(options, History::complete)});
  if (auto octomap = make_octomap(resolution)) all.push_back({kOctomap, std::move(octomap)});
  return all;
}

void insert_all(MapUnderTest& map, const std::vector<Scan>& scans) {
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (!held_out(i, scans.size())) map.prepare(scans[i]);
  }
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (!held_out(i, scans.size())) map.insert(scans[i]);
  }
}

void count(const SeenCells& seen, const MapUnderTest* map, std::span<AccuracyRow> rows) {
  const auto asked = [&](const Cell& cell) {
    return map == nullptr ? std::nullopt : map->probability(cell);
  };
  seen.ends.for_each([&](const Cell& cell) {
    const std::optional<double> probability = asked(cell);
    for (AccuracyRow& row : rows) {
      ++row.ends;
      if (probability && *probability > row.threshold) ++row.ends_right;
    }
  });
  seen.path.for_each([&](const Cell& cell) {
    const std::optional<double> probability = asked(cell);
    for (AccuracyRow& row : rows) {
      ++row.path;
      if (!probability) ++row.path_unknown;
      if (!probability || *probability <= row.threshold) ++row.path_right;
    }
  });
}

}  // namespace

double AccuracyRow::share_of_ends() const { return percent(ends_right, ends); }
double AccuracyRow::share_of_path() const { return percent(path_right, path); }
double AccuracyRow::percentage() const { return percent(ends_right + path_right, ends + path); }
double AccuracyRow::balanced() const { return (share_of_ends() + share_of_path()) / 2; }
double AccuracyRow::percentage_unknown_wrong() const {
  return percent(ends_right + path_right - path_unknown, ends + path);
}
double AccuracyRow::balanced_unknown_wrong() const {
  return (share_of_ends() + percent(path_right - path_unknown, path)) / 2;
}

Json to_json(const AccuracyRow& row) {
  return {{"sequence", row.sequence},
          {"resolution_m", row.resolution},
          {"map", row.map},
          {"threshold", row.threshold},
          {"scans_inserted", row.scans_inserted},
          {"scans_held_out", row.scans_held_out},
          {"judged", row.judged},
          {"ends", row.ends},
          {"ends_right", row.ends_right},
          {"path", row.path},
          {"path_right", row.path_right},
          {"path_unknown", row.path_unknown},
          {"ends_right_percent", row.share_of_ends()},
          {"path_right_percent", row.share_of_path()},
          {"accuracy_percent", row.percentage()},
          {"balanced_percent", row.balanced()},
          {"accuracy_unknown_wrong_percent", row.percentage_unknown_wrong()},
          {"balanced_unknown_wrong_percent", row.balanced_unknown_wrong()}};
}

std::vector<AccuracyRow> accuracy_experiment(const Sequence& sequence, double resolution) {
  const std::vector<Scan>& scans = sequence.scans;
  if (scans.size() < 2) return {};
  std::size_t out = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) out += held_out(i, scans.size()) ? 1 : 0;

  const std::vector<Contender> all = contenders(resolution);
  std::vector<AccuracyRow> rows;
  for (const Contender& one : all) {
    if (one.map) insert_all(*one.map, scans);
    for (const double threshold : kThresholds) {
      rows.push_back({.sequence = sequence.name,
                      .resolution = resolution,
                      .map = one.name,
                      .threshold = threshold,
                      .scans_held_out = out,
                      .scans_inserted = scans.size() - out,
                      .judged = scans.size() >= kFewestJudged});
    }
  }
  const Lattice lattice(resolution);
  for (std::size_t i = 0; i < scans.size(); ++i) {
    if (!held_out(i, scans.size())) continue;
    const SeenCells seen = seen_cells(scans[i], lattice);
    for (std::size_t map = 0; map < all.size(); ++map) {
      count(seen, all[map].map.get(),
            std::span(rows).subspan(map * kThresholds.size(), kThresholds.size()));
    }
  }
  return rows;
}

const AccuracyRow* find_row(const std::vector<AccuracyRow>& rows, const std::string& sequence,
                            const std::string& map, double resolution, double threshold) {
  for (const AccuracyRow& row : rows) {
    if (row.sequence == sequence && row.map == map && row.resolution == resolution &&
        row.threshold == threshold) {
      return &row;
    }
  }
  return nullptr;
}

}  // namespace rmap::evaluation
