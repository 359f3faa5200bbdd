#include "arguments.hpp"
#include "help.hpp"
#include "json.hpp"
#include "map_files.hpp"
#include "output.hpp"
#include "verbs.hpp"

#include <memory>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/map_file.hpp>

namespace rmap::command {

namespace {

struct MergeArguments {
  std::vector<std::filesystem::path> maps;
  std::filesystem::path output;
  bool json = false;
};

Grid merged(const std::vector<std::filesystem::path>& files) {
  Grid sum = load_map(files.front());
  for (std::size_t i = 1; i < files.size(); ++i) {
    const Grid next = load_map(files[i]);
    try {
      sum.merge(next);
    } catch (const Error& error) {
      throw Error(error.kind(), fmt::format("{} and {}: {}", files.front().string(),
                                            files[i].string(), error.what()));
    }
  }
  return sum;
}

void run(const MergeArguments& arguments) {
  if (arguments.maps.size() < 2) {
    throw UsageError("one map cannot be merged: give two or more (see rmap merge --help)");
  }
  check_map_output(arguments.output);
  const Grid sum = merged(arguments.maps);
  save_map(sum, arguments.output);
  if (arguments.json) {
    Json maps = Json::array();
    for (const auto& map : arguments.maps) maps.push_back(map.string());
    print_json({{"output", arguments.output.string()},
                {"maps", maps},
                {"cells", sum.cell_count()},
                {"occupied", occupied_count(sum)},
                {"scans", sum.scan_poses().size()},
                {"history", word_of(sum.history())}});
  } else {
    print(fmt::format("{}: {} with {}, {} of them occupied, {} history of {}\n",
                      arguments.output.string(), counted(arguments.maps.size(), "map"),
                      counted(sum.cell_count(), "cell"), grouped(occupied_count(sum)),
                      word_of(sum.history()), counted(sum.scan_poses().size(), "scan")));
  }
}

}  // namespace

void add_merge(CLI::App& app) {
  CLI::App& verb = *app.add_subcommand("merge", "Add maps up to one.");
  const auto arguments = std::make_shared<MergeArguments>();
  set_help(
      verb,
      {.usage = "MAP MAP... -o MAP [options]",
       .text = {"The maps must have one resolution and one prior. What the maps know of a cell "
                "is added as log-odds and clamped by the options of the first map, which are "
                "those of the result; a cell that only one map has keeps its value."},
       .examples = {"rmap merge street.rmap yard.rmap -o town.rmap"}});
  add_paths(verb, "MAP", arguments->maps, "Maps, .rmap files.")->required();
  add_path(verb, "-o,--output", arguments->output, "The map to write, ending in .rmap.")
      ->required();
  add_json_flag(verb, arguments->json);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
