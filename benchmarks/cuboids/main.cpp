// Cuboids of real scenes and of a noisy room by every method: how many, how good, how small and how
// fast, beside the paper's recursion and a certified lower bound. `--help` says how.
#include "clock.hpp"
#include "support/random.hpp"
#include "support/real_cells.hpp"

#include <algorithm>
#include <exception>
#include <fstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <rmap/approximate.hpp>
#include <rmap/cuboid_bound.hpp>
#include <rmap/cuboid_error.hpp>
#include <rmap/cuboid_map.hpp>

namespace {

using namespace rmap;
using namespace rmap::bench;
using rmap::test::CellScene;

struct Arguments {
  std::vector<std::string> scenes;
  int repetitions = 5;
  double bound_steps = 20;
  int edits = 200;
  std::filesystem::path json;
  std::filesystem::path markdown;
};

struct Contender {
  std::string name;
  ApproximationOptions options;
};

std::vector<Contender> contenders() {
  ApproximationOptions midpoint = approximation_preset("exact");
  midpoint.method = CuboidMethod::midpoint;
  ApproximationOptions half = midpoint;
  half.fill = 0.5;
  ApproximationOptions runs = midpoint;
  runs.method = CuboidMethod::runs;
  ApproximationOptions split = {.method = CuboidMethod::split, .outer = std::nullopt};
  std::vector<Contender> all{{"midpoint", midpoint},
                             {"midpoint, fill 0.5", half},
                             {"runs", runs},
                             {"split and merge, 25 % false", split},
                             {"exact", approximation_preset("exact")},
                             {"default", approximation_preset("default")},
                             {"compact", approximation_preset("compact")},
                             {"sketch", approximation_preset("sketch")}};
  for (const char* name : {"midpoint", "exact"}) {
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const Contender& one) { return one.name == name; });
    Contender tail{at->name + ", sigma .95", at->options};
    tail.options.sigma = 0.95;
    all.push_back(tail);
  }
  return all;
}

struct Figures {
  std::string name;
  std::size_t cuboids = 0;
  double boxes_ns = 0;  ///< a cell, medians
  double ranking_ns = 0;
  double whole_ns = 0;
  double speedup = 0;     ///< of two threads, where boxes are found by tiles
  std::size_t bound = 0;  ///< 0: none computed
  CuboidError error;
  CuboidBytes bytes;
};

double ratio(double a, double b) { return b == 0 ? 0 : a / b; }

/// All contenders in turn, as often as it is wanted.
std::vector<Figures> measure(const CellScene& scene, const Arguments& arguments) {
  const std::vector<Contender> all = contenders();
  std::vector<std::vector<double>> boxes(all.size()), ranking(all.size()), whole(all.size()),
      two(all.size());
  std::vector<Approximation> results(all.size());
  for (int round = 0; round < arguments.repetitions; ++round) {
    for (std::size_t i = 0; i < all.size(); ++i) {
      whole[i].push_back(
          seconds_of([&] { results[i] = approximate(scene.cells, all[i].options); }));
      boxes[i].push_back(results[i].report.seconds_boxes);
      ranking[i].push_back(results[i].report.seconds_ranking);
      ApproximationOptions threads = all[i].options;
      threads.threads = 2;
      const Approximation other = approximate(scene.cells, threads);
      if (other.cuboids != results[i].cuboids) {
        throw std::runtime_error(all[i].name + " is not the same with two threads");
      }
      two[i].push_back(other.report.seconds_boxes);
    }
  }
  std::vector<Figures> figures;
  const double per_cell = 1e9 / static_cast<double>(scene.cells.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    figures.push_back({.name = all[i].name,
                       .cuboids = results[i].cuboids.size(),
                       .boxes_ns = median(boxes[i]) * per_cell,
                       .ranking_ns = median(ranking[i]) * per_cell,
                       .whole_ns = median(whole[i]) * per_cell,
                       .speedup = ratio(median(boxes[i]), median(two[i])),
                       .error = cuboid_error(scene.cells, results[i].cuboids),
                       .bytes = cuboid_bytes(scene.cells, results[i].cuboids)});
  }
  return figures;
}

/// The bound of lists that lose nothing, for two of the presets.
void find_bounds(const CellScene& scene, double steps, std::vector<Figures>& figures) {
  if (steps == 0) return;
  for (const auto& [name, outer] : {std::pair{"exact", 0}, std::pair{"compact", 1}}) {
    const CuboidBound bound = lower_bound(scene.cells, {.outer = outer, .steps_per_cell = steps});
    if (!verify(bound, scene.cells, outer)) throw std::runtime_error("a lower bound is wrong");
    const auto at = std::find_if(figures.begin(), figures.end(),
                                 [&](const Figures& one) { return one.name == name; });
    at->bound = bound.cuboids();
  }
}

struct Edits {
  int outer = 0;
  double more = 0;          ///< cuboids after the edits against doing all again
  double milliseconds = 0;  ///< an edit
};

/// Cubes of cells put in and taken out at random places.
Edits edit(const CellScene& scene, int outer, int count) {
  test::Random random(5);
  CuboidMap map(scene.cells, {.outer = outer});
  double seconds = 0;
  for (int i = 0; i < count; ++i) {
    const auto last = static_cast<std::int32_t>(scene.cells.size()) - 1;
    const Cell at = scene.cells[static_cast<std::size_t>(random.integer(0, last))].cell;
    const bool put = random.chance(0.5);
    const int edge = random.integer(1, 8);
    std::vector<CellState> states;
    for (int z = 0; z < edge; ++z) {
      for (int y = 0; y < edge; ++y) {
        for (int x = 0; x < edge; ++x) states.push_back({at + Cell(x, y, z), put});
      }
    }
    seconds += seconds_of([&] { map.update(states); });
  }
  const std::vector<CountedCell> cells = map.cells();
  const CuboidError error = cuboid_error(cells, map.cuboids());
  if (error.lost_cells > 0 || error.farthest_false > outer) {
    throw std::runtime_error("cuboids of edited cells are wrong");
  }
  const CuboidMap again(cells, {.outer = outer});
  return {outer, ratio(static_cast<double>(map.size()), static_cast<double>(again.size())),
          1e3 * seconds / count};
}

std::string table(const CellScene& scene, const std::vector<Figures>& figures) {
  const double paper = static_cast<double>(figures.front().cuboids);
  const double paper_ns = figures.front().boxes_ns;
  std::string text = fmt::format(
      "### {}: {} cells of {:.4g} m\n\n"
      "| method | cuboids | cells each | of midpoint's | bound | of the bound | OctoMap / 24 B | "
      "bit blocks / 8 B | false | farthest | lost | ns/cell | of midpoint's | ranking | whole call "
      "| "
      "two threads |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
      scene.name, scene.cells.size(), scene.resolution);
  for (const Figures& one : figures) {
    const auto count = static_cast<double>(one.cuboids);
    text += fmt::format(
        "| {} | {} | {:.1f} | {:.3f} | {} | {} | {:.1f} | {:.1f} | {:.1f} % | {} | {:.1f} % | "
        "{:.0f} | {:.1f} | {:.0f} | {:.0f} | {:.2f} |\n",
        one.name, one.cuboids, ratio(static_cast<double>(one.error.cells), count),
        ratio(count, paper), one.bound == 0 ? "" : std::to_string(one.bound),
        one.bound == 0 ? "" : fmt::format("{:.4f}", count / static_cast<double>(one.bound)),
        ratio(static_cast<double>(one.bytes.octomap), static_cast<double>(one.bytes.plain)),
        ratio(static_cast<double>(one.bytes.bit_blocks), static_cast<double>(one.bytes.packed)),
        100 * one.error.false_share(), one.error.farthest_false,
        100 *
            ratio(static_cast<double>(one.error.lost_cells), static_cast<double>(one.error.cells)),
        one.boxes_ns, ratio(one.boxes_ns, paper_ns), one.ranking_ns, one.whole_ns, one.speedup);
  }
  return text + "\n";
}

nlohmann::json to_json(const Figures& one) {
  return {{"method", one.name},
          {"cuboids", one.cuboids},
          {"lower_bound", one.bound},
          {"ns_per_cell",
           {{"boxes", one.boxes_ns}, {"ranking", one.ranking_ns}, {"whole", one.whole_ns}}},
          {"two_threads", one.speedup},
          {"lost_cells", one.error.lost_cells},
          {"false_share", one.error.false_share()},
          {"farthest_false", one.error.farthest_false},
          {"farthest_lost", one.error.farthest_lost},
          {"bytes",
           {{"plain", one.bytes.plain},
            {"packed", one.bytes.packed},
            {"octomap", one.bytes.octomap},
            {"bit_blocks", one.bytes.bit_blocks}}}};
}

CellScene scene_named(const std::string& name) {
  if (name != "noisy_room") return test::real_cell_scene(name);
  constexpr double kResolution = 0.05;
  return {name, kResolution, quantize(test::room_points(4000, 0.01), Lattice(kResolution)).cells};
}

void run(const Arguments& arguments) {
  std::vector<std::string> names = arguments.scenes;
  if (names.empty()) {
    names = test::cell_scene_names();
    names.insert(names.begin(), "noisy_room");
  }
  nlohmann::json json = nlohmann::json::array();
  std::string markdown;
  for (const std::string& name : names) {
    const CellScene scene = scene_named(name);
    if (scene.cells.empty()) {
      fmt::print(stderr, "{}: its data is not there\n", name);
      continue;
    }
    std::vector<Figures> figures = measure(scene, arguments);
    find_bounds(scene, arguments.bound_steps, figures);
    markdown += table(scene, figures);
    nlohmann::json methods = nlohmann::json::array();
    for (const Figures& one : figures) methods.push_back(to_json(one));
    json.push_back({{"scene", name}, {"cells", scene.cells.size()}, {"methods", methods}});
    if (arguments.edits > 0 && name == "office") {
      for (const int outer : {0, 1}) {
        const Edits edits = edit(scene, outer, arguments.edits);
        markdown += fmt::format(
            "{} edits one by one, outer {}: {:.4f} times the cuboids of doing all again, {:.2f} ms "
            "an edit.\n\n",
            arguments.edits, outer, edits.more, edits.milliseconds);
      }
    }
    fmt::print(stderr, "{}\n", name);
  }
  fmt::print("{}", markdown);
  if (!arguments.json.empty()) std::ofstream(arguments.json) << json.dump(2) << "\n";
  if (!arguments.markdown.empty()) std::ofstream(arguments.markdown) << markdown;
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app("Cuboids of real scenes: how many, how good, how small, how fast.");
  app.add_option("scenes", arguments.scenes,
                 "noisy_room, office, street, hall, bunny, fr_079, fr_campus (default: all)");
  app.add_option("--repetitions", arguments.repetitions, "for the clock")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--bound-steps", arguments.bound_steps,
                 "steps a cell of the search for a lower bound; 0: no bound")
      ->capture_default_str();
  app.add_option("--edits", arguments.edits, "changes of the office, one by one; 0: none")
      ->capture_default_str();
  app.add_option("--json", arguments.json, "file for the figures");
  app.add_option("--markdown", arguments.markdown, "file for the tables");
  CLI11_PARSE(app, argc, argv);
  try {
    run(arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "rmap_bench_cuboids: {}\n", error.what());
    return 1;
  }
}
