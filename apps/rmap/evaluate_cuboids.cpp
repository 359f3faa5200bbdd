#include "arguments.hpp"
#include "cuboid_input.hpp"
#include "cuboid_report.hpp"
#include "help.hpp"
#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

#include <memory>

#include <fmt/format.h>

#include <rmap/cuboid_bound.hpp>
#include <rmap/cuboid_files.hpp>
#include <rmap/error.hpp>

namespace rmap::command {

namespace {

struct EvaluateArguments {
  std::filesystem::path input;
  std::filesystem::path cuboids;
  bool lower_bound = false;
  int steps = 20;
  bool json = false;
};

struct Bound {
  int outer;
  std::size_t cuboids;
};

// The bound for the empty cells that the cuboids themselves allow.
Bound bound_of(std::span<const CountedCell> cells, const CuboidError& error, int steps) {
  if (error.lost_cells > 0) {
    throw Error(ErrorKind::input,
                fmt::format("--lower-bound is for cuboids that lose nothing: these lose {} of {} "
                            "cells",
                            error.lost_cells, error.cells));
  }
  const CuboidBound bound =
      lower_bound(cells, {.outer = error.farthest_false, .steps_per_cell = double(steps)});
  if (!verify(bound, cells, error.farthest_false)) {
    throw Error(ErrorKind::usage, "the lower bound that was found does not hold: please report it");
  }
  return {error.farthest_false, bound.cuboids()};
}

CuboidInput read_cells(const EvaluateArguments& arguments, const CuboidList& list) {
  const std::filesystem::path& file = arguments.input;
  CuboidInputOptions options{.resolution = list.resolution};
  options.frame.given = list.frame;
  return read_cuboid_input(file, options);
}

void run(const EvaluateArguments& arguments) {
  const CuboidList list = read_cuboids(arguments.cuboids);
  const CuboidInput input = read_cells(arguments, list);
  const CuboidEvaluation evaluation = evaluate_cuboids(input.cells, list.cuboids);
  const CuboidError& error = evaluation.error;
  std::optional<Bound> bound;
  constexpr int kMostOuter = 3;
  const bool too_far = error.farthest_false > kMostOuter;
  if (arguments.lower_bound && !too_far) bound = bound_of(input.cells, error, arguments.steps);
  const double over = bound ? static_cast<double>(error.cuboids) /
                                  static_cast<double>(std::max<std::size_t>(bound->cuboids, 1))
                            : 0;
  if (arguments.json) {
    Json answer = json_of(error);
    answer["resolution"] = list.resolution;
    answer["frame"] = json_of_frame(list.frame);
    answer["bytes"] = json_of(evaluation.bytes);
    Json trees = Json::object();
    for (const auto& [branches, bytes] : evaluation.rtree_bytes) {
      trees[std::to_string(branches)] = bytes;
    }
    answer["rtree_bytes"] = trees;
    answer["lower_bound"] = bound ? Json(bound->cuboids) : Json(nullptr);
    answer["remarks"] = remarks(evaluation);
    print_json(answer);
    return;
  }
  std::string text = fmt::format("{}: {} for {} of {}\n", arguments.cuboids.string(),
                                 counted(error.cuboids, "cuboid"), counted(error.cells, "cell"),
                                 arguments.input.string());
  text += error_lines(error);
  if (bound) {
    text += fmt::format(
        "bound        no list with empty cells at most {} off has fewer than {}: "
        "{:.3f} times that many\n",
        bound->outer, grouped(bound->cuboids), over);
  }
  if (arguments.lower_bound && too_far) {
    text += fmt::format(
        "bound        none: empty cells lie up to {} off, and bounds are for {} at "
        "most\n",
        error.farthest_false, kMostOuter);
  }
  text += byte_lines(evaluation);
  for (const std::string& remark : remarks(evaluation)) text += "note: " + remark + "\n";
  print(text);
}

}  // namespace

void add_evaluate_cuboids(CLI::App& app) {
  CLI::App& verb =
      *app.add_subcommand("evaluate-cuboids", "Tell how well cuboids stand for a map or a cloud.");
  const auto arguments = std::make_shared<EvaluateArguments>();
  set_help(
      verb,
      {.usage = "IN CUBOIDS [options]",
       .text = {"IN is what `rmap approximate` takes, CUBOIDS a .rcs or .csv file that it "
                "wrote; points of IN are brought into the frame of the cuboids. The answer "
                "counts, cell by cell, what is lost and what is false, and the bytes that "
                "the same takes in other forms.",
                "--lower-bound looks for occupied cells no two of which fit into one cuboid "
                "that is allowed: no list of cuboids that loses nothing can have fewer. "
                "Allowed are empty cells as far from occupied ones as those in CUBOIDS, 3 cells at "
                "most. It takes seconds for exact lists and up to minutes for others."},
       .examples = {"rmap evaluate-cuboids street.rmap street.rcs",
                    "rmap evaluate-cuboids street.rmap street.rcs --lower-bound --json"}});
  add_path(verb, "IN", arguments->input, "Map, cloud, or folder of scans.", "IN")->required();
  add_path(verb, "CUBOIDS", arguments->cuboids, "A .rcs or .csv file.", "CUBOIDS")->required();
  verb.add_flag("--lower-bound", arguments->lower_bound, "Compute the certified lower bound too.");
  add_integer(verb, "--steps", arguments->steps,
              "Steps of its search for each cell: more give a higher bound (default 20).", 0);
  add_json_flag(verb, arguments->json);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
