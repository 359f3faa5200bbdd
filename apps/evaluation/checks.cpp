#include "evaluation/checks.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace rmap::evaluation {

namespace {

// Whether each value is at most the one before, give or take `slack` of it.
bool falls(const std::vector<double>& values, double slack = 0) {
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (values[i] > values[i - 1] * (1 + slack)) return false;
  }
  return values.size() > 1 && values.back() < values.front();
}

bool rises(std::vector<double> values, double slack = 0) {
  std::reverse(values.begin(), values.end());
  return falls(values, slack);
}

std::string listed(const std::vector<double>& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values) texts.push_back(fmt::format("{:.4g}", value));
  return fmt::format("{}", fmt::join(texts, ", "));
}

// Of smaller trees single nodes and pages of memory decide.
constexpr std::size_t kFewestItems = 20'000;
constexpr int kLargestJudgedM = 32;

double ratio(std::uint64_t a, std::uint64_t b) {
  return b == 0 ? 0 : static_cast<double>(a) / static_cast<double>(b);
}

}  // namespace

Json to_json(const Check& check) {
  return {{"experiment", check.experiment}, {"subject", check.subject}, {"claim", check.claim},
          {"shown", check.shown},           {"holds", check.holds},     {"judged", check.judged}};
}

std::vector<Check> check_rtree(std::span<const RTreeRow> rows) {
  std::vector<Check> checks;
  for (const char* leaves : {"cells", "blocks"}) {
    for (const char* built : {"quadratic", "linear", "bulk"}) {
      std::vector<double> nodes, bytes, overlap, insert, extract;
      std::size_t items = 0;
      for (const RTreeRow& row : rows) {
        if (row.leaves != leaves || row.built != built) continue;
        items = row.items;
        nodes.push_back(static_cast<double>(row.nodes));
        bytes.push_back(static_cast<double>(row.bytes));
        insert.push_back(row.insert_ns);
        extract.push_back(row.extract_ns);
        if (row.max_branches <= kLargestJudgedM) overlap.push_back(row.overlap_of_node);
      }
      if (nodes.empty()) continue;
      const bool are_cells = std::string(leaves) == "cells";
      const bool are_many = items >= kFewestItems;
      const auto add = [&](const std::string& claim, const std::vector<double>& values, bool holds,
                           bool judged) {
        checks.push_back({.experiment = "rtree",
                          .subject = fmt::format("{}, {}", leaves, built),
                          .claim = claim,
                          .shown = listed(values),
                          .holds = holds,
                          .judged = judged});
      };
      add("The larger M, the fewer nodes.", nodes, falls(nodes), are_many);
      // Blocks are so few that whole pages of memory decide.
      add("The larger M, the less memory.", bytes, falls(bytes), are_many && are_cells);
      // Packed trees have little to overlap, and of few blocks a large M makes but one or two
      // levels: there ours may differ from the paper, which inserts cells one by one with the
      // quadratic split. The linear one scatters, and so does M = 64, which has few inner nodes.
      add(fmt::format("The larger M, the more overlap within a node, up to M = {}.",
                      kLargestJudgedM),
          overlap, rises(overlap), are_many && are_cells && std::string(built) == "quadratic");
      // Times are told, not judged.
      add("The larger M, the faster it is to go over all.", extract, falls(extract), false);
      add("The larger M, the slower the insertion.", insert, rises(insert), false);
    }
  }
  return checks;
}

std::vector<Check> check_grid(const GridFindings& findings) {
  const GridRun* octomap = findings.find(kOctomapRun);
  if (octomap == nullptr) return {};
  std::vector<Check> checks;
  const std::string at = fmt::format("{} at {} m", findings.sequence, findings.resolution);
  const GridFindings::Reference& reference = findings.references.back();
  const std::uint64_t least = std::min({*reference.uncompressed, *reference.pruned,
                                        *reference.maximum_likelihood, reference.full_grid});
  for (const GridRun& run : findings.runs) {
    if (run.is_octomap) continue;
    const GridSample& last = run.last();
    const auto add = [&](const char* claim, const std::string& shown, bool holds, bool judged) {
      checks.push_back({.experiment = "grid",
                        .subject = fmt::format("{}, {}", at, run.map),
                        .claim = claim,
                        .shown = shown,
                        .holds = holds,
                        .judged = judged});
    };
    // Of smaller maps pages of memory and the start of a loop decide.
    constexpr std::uint64_t kFewestJudged = 5000;
    const bool judged = *last.occupied >= kFewestJudged;
    add("The map takes less memory than OctoMap's, uncompressed.",
        fmt::format("{} bytes against {}", *last.bytes, *reference.uncompressed),
        *last.bytes < *reference.uncompressed, true);
    add("The map takes less memory than any form of OctoMap and than the full grid.",
        fmt::format("{} bytes against {} at least", *last.bytes, least), *last.bytes < least,
        judged);
    const double faster = *octomap->last().extract_ms / *last.extract_ms;
    add("Going over the occupied cells is faster than OctoMap's.",
        fmt::format("{:.4g} times", faster), faster > 1, judged);
    const double sooner = octomap->insert_ms() / run.insert_ms();
    add("Inserting a scan is faster than OctoMap's.", fmt::format("{:.4g} times", sooner),
        sooner > 1, judged);
  }
  return checks;
}

std::vector<Check> check_accuracy(const std::vector<AccuracyRow>& rows, const std::string& sequence,
                                  double resolution, bool demands_paper) {
  constexpr double kPaper = 99;             // percent
  constexpr double kFirstHitMayLose = 0.5;  // points
  std::vector<Check> checks;
  for (const double threshold : {0.9, 0.5}) {
    const auto row = [&](const char* map) {
      return find_row(rows, sequence, map, resolution, threshold);
    };
    const AccuracyRow* complete = row(kComplete);
    const AccuracyRow* first_hit = row(kFirstHit);
    const AccuracyRow* octomap = row(kOctomap);
    if (complete == nullptr || first_hit == nullptr) continue;
    const auto add = [&](const std::string& claim, const std::string& shown, bool holds) {
      checks.push_back(
          {.experiment = "accuracy",
           .subject = fmt::format("{} at {} m, p > {}", sequence, resolution, threshold),
           .claim = claim,
           .shown = shown,
           .holds = holds,
           .judged = complete->judged});
    };
    // What implicit free space saves: fewer of the free cells are kept than OctoMap keeps.
    const auto keeps_fewer = [&](const AccuracyRow* ours) {
      return octomap == nullptr || ours->path_unknown > octomap->path_unknown;
    };
    const auto kept = [&](const AccuracyRow* ours) {
      if (octomap == nullptr) return std::string();
      return fmt::format("; {} of {} path cells kept against {}", ours->path - ours->path_unknown,
                         ours->path, octomap->path - octomap->path_unknown);
    };
    if (demands_paper && threshold == 0.9) {
      for (const AccuracyRow* ours : {complete, first_hit}) {
        add(fmt::format("{}: 99 % of the cells are right, with fewer cells kept than by OctoMap.",
                        ours->map),
            fmt::format("{:.3f} %{}", ours->percentage(), kept(ours)),
            ours->percentage() >= kPaper && keeps_fewer(ours));
      }
    }
    if (octomap == nullptr) continue;
    add("With complete history the balanced accuracy is no less than OctoMap's, with fewer cells "
        "kept.",
        fmt::format("{:.4f} against {:.4f}{}", complete->balanced(), octomap->balanced(),
                    kept(complete)),
        complete->balanced() >= octomap->balanced() && keeps_fewer(complete));
    add("With first-hit history the balanced accuracy is at most 0.5 points below OctoMap's, with "
        "fewer cells kept.",
        fmt::format("{:.4f} against {:.4f}{}", first_hit->balanced(), octomap->balanced(),
                    kept(first_hit)),
        first_hit->balanced() >= octomap->balanced() - kFirstHitMayLose && keeps_fewer(first_hit));
  }
  return checks;
}

std::vector<Check> check_history(const HistoryRow& row) {
  std::vector<Check> checks;
  constexpr std::size_t kFewestScans = 6;  // few scans may have nothing to lose
  const bool judged = row.scans >= kFewestScans;
  const std::string at = fmt::format("{} at {} m", row.sequence, row.resolution);
  checks.push_back({.experiment = "history",
                    .subject = at,
                    .claim = "First-hit history adds false cells and loses none.",
                    .shown = fmt::format("{} false ({:.2f} %), {} lost", row.false_cells,
                                         row.false_percent(), row.lost_cells),
                    .holds = row.false_cells > 0 && row.lost_cells == 0,
                    .judged = judged});
  if (row.octomap) {
    // Borders of cells are decided in float there: a few in a million beams.
    constexpr double kMayDiffer = 1e-3;
    const std::uint64_t different = row.octomap->only_complete + row.octomap->only_octomap;
    checks.push_back(
        {.experiment = "history",
         .subject = at,
         .claim = "Complete history has OctoMap's occupied cells; first-hit history has more.",
         .shown = fmt::format("{} of {} differ; {} more with first-hit", different,
                              row.octomap->occupied, row.octomap->first_hit_false),
         .holds = ratio(different, row.octomap->occupied) <= kMayDiffer &&
                  row.octomap->first_hit_false > different,
         .judged = judged});
  }
  return checks;
}

std::vector<Check> check_multiresolution(const MultiresolutionFindings& findings) {
  std::vector<double> nearest;
  for (const auto& size : findings.sizes) nearest.push_back(size.nearest);
  // Of a scan that lies near as a whole every query cuboid is a cell.
  const bool judged = findings.sizes.size() > 1;
  return {{.experiment = "multiresolution",
           .subject = findings.sequence,
           .claim = "Cuboids that are coarser far away are fewer than the cells.",
           .shown = fmt::format("{} for {} cells", findings.cuboids, findings.cells),
           .holds = findings.cuboids < findings.cells,
           .judged = judged},
          {.experiment = "multiresolution",
           .subject = findings.sequence,
           .claim = "The coarser the cuboids, the farther the nearest of them.",
           .shown = listed(nearest) + " m",
           .holds = rises(nearest),
           .judged = judged}};
}

std::vector<Check> check_cuboids(const CuboidFindings& findings, const std::string& scene) {
  std::vector<Check> checks;
  const auto cloud = std::find_if(findings.clouds.begin(), findings.clouds.end(),
                                  [&](const CloudBytes& one) { return one.scene == scene; });
  if (cloud == findings.clouds.end()) return {};
  constexpr std::size_t kFewestCells = 1000;
  const bool judged = cloud->cells >= kFewestCells;
  for (const char* method : {kMidpoint, kExact, kDefault}) {
    const auto add = [&](const char* claim, const std::string& shown, bool holds) {
      checks.push_back({.experiment = "cuboids",
                        .subject = fmt::format("{}, {}", scene, method),
                        .claim = claim,
                        .shown = shown,
                        .holds = holds,
                        .judged = judged});
    };
    for (const char* varied : {"sigma", "omega"}) {
      std::vector<double> cuboids, lost;
      std::vector<CuboidRow> rows;
      for (const CuboidRow& row : findings.rows) {
        if (row.scene == scene && row.method == method && row.varied == varied) rows.push_back(row);
      }
      if (rows.empty()) continue;
      for (const CuboidRow& row : rows) {
        cuboids.push_back(static_cast<double>(row.cuboids));
        lost.push_back(row.unapproximated_percent);
      }
      if (std::string(varied) == "sigma") {
        add("The smaller sigma, the fewer cuboids.", listed(cuboids), rises(cuboids));
        add("The smaller sigma, the more points are left out, 1 - sigma of them at most.",
            listed(lost), falls(lost) && std::all_of(rows.begin(), rows.end(), [](const auto& row) {
                            return row.unapproximated_percent <= 100 * (1 - row.sigma) + 1e-6;
                          }));
        // Of the whole cloud: sigma 1.
        const CuboidRow& whole = rows.back();
        add("The R-tree of the cuboids takes less the larger M.",
            fmt::format("{}, {}, {} bytes", whole.rtree_bytes[0], whole.rtree_bytes[1],
                        whole.rtree_bytes[2]),
            whole.rtree_bytes[0] > whole.rtree_bytes[1] &&
                whole.rtree_bytes[1] > whole.rtree_bytes[2]);
        const auto nearly = std::find_if(rows.begin(), rows.end(),
                                         [](const CuboidRow& row) { return row.sigma == 0.95; });
        if (nearly != rows.end()) {
          const std::uint64_t least = std::min({cloud->raw_points, cloud->octomap});
          add("Cuboids of 95 % of the points take less than the points and than an OctoMap of "
              "them.",
              fmt::format("{} bytes against {}", nearly->bytes, least), nearly->bytes < least);
        }
      } else {
        add("The larger omega, the fewer cuboids.", listed(cuboids), falls(cuboids));
      }
    }
  }
  return checks;
}

}  // namespace rmap::evaluation
