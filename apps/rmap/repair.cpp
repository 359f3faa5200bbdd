#include "arguments.hpp"
#include "help.hpp"
#include "json.hpp"
#include "map_files.hpp"
#include "output.hpp"
#include "verbs.hpp"

#include <memory>
#include <optional>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/map_repair.hpp>

namespace rmap::command {

namespace {

struct RepairArguments {
  std::filesystem::path input;
  std::filesystem::path output;
  std::optional<double> resolution;
  bool json = false;
};

Json json_of(const MapCounts& counts) {
  return {{"scans", counts.scans}, {"blocks", counts.blocks}, {"cells", counts.cells}};
}

Json json_of(const MapRepair& repair) {
  Json problems = Json::array();
  for (const MapProblem& problem : repair.problems) problems.push_back(problem.sentence);
  return {{"problems", problems},
          {"salvaged", json_of(repair.salvaged)},
          {"announced", repair.announced ? json_of(*repair.announced) : Json(nullptr)},
          {"options_lost", repair.options_lost},
          {"history_lost", repair.history_lost},
          {"history", word_of(repair.grid.history())}};
}

std::string part_of(std::uint64_t salvaged, std::optional<std::uint64_t> announced,
                    std::string_view noun) {
  if (!announced) return counted(salvaged, noun);
  return fmt::format("{} of {}", grouped(salvaged), counted(*announced, noun));
}

std::string words_of(const MapRepair& repair) {
  if (repair.problems.empty()) return "  nothing was wrong: it is the same map\n";
  std::string words;
  for (const MapProblem& problem : repair.problems)
    words += "  problem     " + problem.sentence + "\n";
  const auto announced = [&](std::uint64_t MapCounts::*count) {
    return repair.announced ? std::optional((*repair.announced).*count) : std::nullopt;
  };
  words += fmt::format("  salvaged    {}, {}, {}{}\n",
                       part_of(repair.salvaged.cells, announced(&MapCounts::cells), "cell"),
                       part_of(repair.salvaged.blocks, announced(&MapCounts::blocks), "block"),
                       part_of(repair.salvaged.scans, announced(&MapCounts::scans), "scan pose"),
                       repair.announced ? "" : "; how many there were is lost with the header");
  if (repair.history_lost) words += "  history     lost: first_hit from here on\n";
  if (repair.options_lost) {
    words += "  options     lost: the defaults but for the resolution, so that states may differ\n";
  }
  return words;
}

void refuse_same_file(const RepairArguments& arguments) {
  std::error_code missing;
  if (!std::filesystem::equivalent(arguments.input, arguments.output, missing)) return;
  throw Error(ErrorKind::input,
              fmt::format("{} is the input too: a repaired map goes to a file of its own, so that "
                          "nothing is lost that could still be salvaged",
                          arguments.output.string()));
}

void run(const RepairArguments& arguments) {
  check_map_output(arguments.output);
  refuse_same_file(arguments);
  const MapRepair repair = repair_map(arguments.input, {.resolution = arguments.resolution});
  save_map(repair.grid, arguments.output);
  if (arguments.json) {
    Json answer{{"input", arguments.input.string()}, {"output", arguments.output.string()}};
    answer.update(json_of(repair));
    print_json(answer);
  } else {
    print(fmt::format("{}: {}\n{}", arguments.output.string(),
                      counted(repair.grid.cell_count(), "cell"), words_of(repair)));
  }
}

}  // namespace

void add_repair(CLI::App& app) {
  CLI::App& verb = *app.add_subcommand("repair", "Salvage what is intact of a damaged map.");
  const auto arguments = std::make_shared<RepairArguments>();
  set_help(
      verb,
      {.usage = "IN OUT [options]",
       .text = {"Makes a new map of all chunks of a .rmap file that their checksums confirm, also "
                "behind damage, missing bytes or added ones, and tells what is lost, compared "
                "with what the file's header announces. IN stays as it is. When chunks with "
                "cells are lost the history is first_hit from then on.",
                "A map that lost its options needs --resolution; the other options then have "
                "their defaults."},
       .examples = {"rmap repair street.rmap salvaged.rmap"}});
  add_path(verb, "IN", arguments->input, "The damaged map, a .rmap file.")->required();
  add_path(verb, "OUT", arguments->output, "The map to write, ending in .rmap.")->required();
  add_number(verb, "--resolution", arguments->resolution,
             "Edge of a cell (m), for a map that has lost its options.");
  add_json_flag(verb, arguments->json);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
