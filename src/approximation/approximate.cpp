#include "approximation/cell_blocks.hpp"
#include "approximation/cover_tiles.hpp"
#include "approximation/merge_boxes.hpp"
#include "approximation/midpoint.hpp"
#include "approximation/ranking.hpp"
#include "approximation/runs.hpp"
#include "approximation/split_boxes.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include <rmap/approximate.hpp>
#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr int kMostTolerance = 3;
constexpr int kMostThreads = 1024;
// Room that the limited merge and the merge after a split leave for each other: merging costs
// less empty volume for a box saved than pruning does.
constexpr double kShareOfSplit = 0.7;
constexpr double kAnyShare = 1;

void require(bool holds, const std::string& sentence) {
  if (!holds) throw Error(ErrorKind::input, sentence);
}

// NaN fails every comparison, so it is refused as well.
void check(const ApproximationOptions& options) {
  const auto tolerance = [](const char* name, int cells) {
    require(
        cells >= 0 && cells <= kMostTolerance,
        fmt::format("{} is {}: it must lie between 0 and {} cells", name, cells, kMostTolerance));
  };
  if (options.outer) tolerance("outer", *options.outer);
  require(options.outer || options.max_false,
          "there is neither outer nor max_false: one must say what may be false");
  require(options.outer || options.method != CuboidMethod::cover,
          "the method cover needs outer: how far an empty cell of a cuboid may be from an occupied "
          "one");
  tolerance("inner", options.inner);
  require(options.sigma > 0 && options.sigma <= 1,
          fmt::format("sigma is {}: it must be above 0 and at most 1", options.sigma));
  require(options.fill > 0 && options.fill <= 1,
          fmt::format("fill is {}: it must be above 0 and at most 1", options.fill));
  require(options.omega >= 1, "omega is 0: a cuboid adds a weight of 1 at least");
  if (options.max_false) {
    require(*options.max_false >= 0 && *options.max_false < 1,
            fmt::format("max_false is {}: it must be at least 0 and below 1", *options.max_false));
  }
  require(
      options.threads >= 0 && options.threads <= kMostThreads,
      fmt::format("threads is {}: it must lie between 0 and {}", options.threads, kMostThreads));
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<CellBox> cover_boxes(const CellBlocks& cells, const ApproximationOptions& options) {
  const int outer = options.outer.value_or(0);
  if (!options.max_false || outer == 0) {
    return cover_by_tiles(cells, {.outer = outer, .inner = options.inner}, options.threads);
  }
  // Exact boxes, joined as far as both limits allow.
  const std::vector<CellBox> exact = cover_by_tiles(cells, {}, options.threads);
  std::vector<CellBox> tight;
  for (const RankedBox& box : ranked(cells, exact, CuboidWeight::cells, 0)) {
    tight.push_back(box.box);
  }
  const CellBlocks allowed = cells.dilated(outer);
  return merge_boxes(cells, tight, *options.max_false, &allowed);
}

std::vector<CellBox> split_and_merge(const CellBlocks& cells, std::span<const CountedCell> sorted,
                                     const ApproximationOptions& options) {
  const double max_false = options.max_false.value_or(kAnyShare);
  if (options.outer) {
    // Only full boxes are known to keep to it before they are merged.
    const std::vector<CellBox> full = split_boxes(sorted, 0);
    if (*options.outer == 0) return full;
    const CellBlocks allowed = cells.dilated(*options.outer);
    return merge_boxes(cells, full, max_false, &allowed);
  }
  if (max_false == 0) return split_boxes(sorted, 0);
  return merge_boxes(cells, split_boxes(sorted, kShareOfSplit * max_false), max_false, nullptr);
}

struct Choice {
  CuboidMethod method;
  std::string why;
};

Choice choose(const ApproximationOptions& options) {
  if (options.method != CuboidMethod::automatic) return {options.method, "it was asked for"};
  if (!options.outer) {
    return {CuboidMethod::split, "only the share of empty cells is bounded, not where they lie"};
  }
  return {CuboidMethod::cover,
          "it needs fewest cuboids for what may be false and lost, and bounds both"};
}

std::uint64_t points_in(const CellBlocks& cells, const CellBox& box) {
  std::uint64_t points = 0;
  cells.for_each(box, [&](const Cell&, std::size_t number) { points += cells.points(number); });
  return points;
}

}  // namespace

ApproximationOptions approximation_preset(std::string_view name) {
  if (name == "exact") return {.outer = 0, .max_false = std::nullopt};
  if (name == "default") return {};
  if (name == "compact") return {.outer = 1, .max_false = std::nullopt};
  if (name == "sketch") {
    return {.outer = 2, .inner = 1, .sigma = 0.98, .omega = 4, .max_false = std::nullopt};
  }
  throw Error(
      ErrorKind::input,
      fmt::format("there is no preset \"{}\": there are exact, default, compact, sketch", name));
}

Approximation approximate(std::span<const CountedCell> input, const ApproximationOptions& options) {
  check(options);
  check_cells(input);
  Approximation result;
  ApproximationReport& report = result.report;
  const Choice choice = choose(options);
  report.method = choice.method;
  report.why = choice.why;

  auto start = std::chrono::steady_clock::now();
  const std::vector<CountedCell> sorted = sorted_cells({input.begin(), input.end()});
  const CellBlocks cells(sorted);
  std::vector<CellBox> boxes;
  switch (choice.method) {
    case CuboidMethod::automatic:
    case CuboidMethod::cover:
      boxes = cover_boxes(cells, options);
      break;
    case CuboidMethod::split:
      boxes = split_and_merge(cells, sorted, options);
      break;
    case CuboidMethod::runs:
      boxes = run_boxes(sorted);
      break;
    case CuboidMethod::midpoint:
      boxes = midpoint_boxes(sorted, options.fill, options.smallest_volume);
      break;
  }
  report.seconds_boxes = seconds_since(start);

  start = std::chrono::steady_clock::now();
  report.cells = cells.size();
  for (std::size_t i = 0; i < cells.size(); ++i) report.points += cells.points(i);
  report.weight = options.weight == CuboidWeight::cells ? report.cells : report.points;
  // Merged boxes hold every cell, and the others know no tolerance for what is lost.
  const bool merged = options.max_false && options.outer != 0;
  const int inner = choice.method == CuboidMethod::cover && !merged ? options.inner : 0;
  const std::vector<RankedBox> list = ranked(cells, boxes, options.weight, inner);
  const auto wanted =
      static_cast<std::uint64_t>(std::ceil(options.sigma * static_cast<double>(report.weight)));
  for (const RankedBox& box : list) {
    if (report.covered >= wanted || box.gain < options.omega ||
        result.cuboids.size() == options.max_cuboids) {
      break;
    }
    report.covered += box.gain;
    result.cuboids.push_back({box.box, points_in(cells, box.box)});
  }
  report.cut = list.size() - result.cuboids.size();
  report.seconds_ranking = seconds_since(start);
  return result;
}

}  // namespace rmap
