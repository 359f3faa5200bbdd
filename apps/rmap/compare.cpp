#include "arguments.hpp"
#include "help.hpp"
#include "json.hpp"
#include "map_files.hpp"
#include "octomap_maps.hpp"
#include "output.hpp"
#include "verbs.hpp"

#include <memory>
#include <vector>

#include <fmt/format.h>

#include <rmap/compare.hpp>
#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap::command {

namespace {

struct CompareArguments {
  std::filesystem::path a;
  std::filesystem::path b;
  OctomapOptions octomap;
  bool expect_equal = false;
  bool json = false;
};

void print_difference(const Grid& a, const Grid& b, const MapDifference& difference, bool json) {
  const bool same = same_map(a, b);
  if (json) {
    print_json({{"cells", {{"a", a.cell_count()}, {"b", b.cell_count()}}},
                {"both", difference.both},
                {"only_a", difference.only_a},
                {"only_b", difference.only_b},
                {"occupied_both", difference.occupied_both},
                {"occupied_only_a", difference.occupied_only_a},
                {"occupied_only_b", difference.occupied_only_b},
                {"state_differences", difference.state_differs},
                {"value_differences", difference.value_differs},
                {"max_difference", difference.max_difference},
                {"equal", difference.same_cells()},
                {"same_map", same}});
    return;
  }
  print(
      fmt::format("cells        {} in both, {} in A only, {} in B only\n"
                  "occupied     {} in both, {} in A only, {} in B only\n"
                  "differences  {} states, {} values, at most {:.6g} in probability\n"
                  "{}\n",
                  grouped(difference.both), grouped(difference.only_a), grouped(difference.only_b),
                  grouped(difference.occupied_both), grouped(difference.occupied_only_a),
                  grouped(difference.occupied_only_b), grouped(difference.state_differs),
                  grouped(difference.value_differs), difference.max_difference,
                  same                      ? "the same map"
                  : difference.same_cells() ? "equal cells; options, scans or history differ"
                                            : "different cells"));
}

void print_cloud_comparison(const Grid& grid, const CloudComparison& found, bool json) {
  if (json) {
    print_json({{"points", found.points},
                {"not_finite", found.not_finite},
                {"beyond_limits", found.beyond_limits},
                {"in_occupied", found.in_occupied},
                {"in_free", found.in_free},
                {"in_assumed_free", found.in_assumed_free},
                {"cells", grid.cell_count()},
                {"cells_without_point", found.cells_without_point},
                {"occupied", occupied_count(grid)},
                {"occupied_without_point", found.occupied_without_point}});
    return;
  }
  print(fmt::format(
      "points  {}: {} in occupied, {} in free, {} in assumed_free cells; {} beyond "
      "limits, {} not finite\n"
      "cells   {}: {} without a point\n"
      "        {} occupied: {} without a point\n",
      grouped(found.points), grouped(found.in_occupied), grouped(found.in_free),
      grouped(found.in_assumed_free), grouped(found.beyond_limits), grouped(found.not_finite),
      grouped(grid.cell_count()), grouped(found.cells_without_point), grouped(occupied_count(grid)),
      grouped(found.occupied_without_point)));
}

void run(const CompareArguments& arguments) {
  if (is_point_file(arguments.b)) {
    if (arguments.expect_equal) {
      throw UsageError("--expect-equal compares two maps: a cloud is never equal to one");
    }
    const Grid grid = read_any_map(arguments.a, arguments.octomap.import_options()).grid;
    print_cloud_comparison(grid, compare_with_cloud(grid, read_points(arguments.b)),
                           arguments.json);
    return;
  }
  const Grid a = read_any_map(arguments.a, arguments.octomap.import_options()).grid;
  const Grid b = read_any_map(arguments.b, arguments.octomap.import_options()).grid;
  const MapDifference difference = compare(a, b);
  print_difference(a, b, difference, arguments.json);
  if (arguments.expect_equal && !difference.same_cells()) {
    throw Error(
        ErrorKind::input,
        fmt::format("{} and {} are not equal: {} cells are in one only, {} have another value",
                    arguments.a.string(), arguments.b.string(),
                    difference.only_a + difference.only_b, difference.value_differs));
  }
}

}  // namespace

void add_compare(CLI::App& app) {
  CLI::App& verb =
      *app.add_subcommand("compare", "Tell how two maps, or a map and a cloud, differ.");
  const auto arguments = std::make_shared<CompareArguments>();
  set_help(
      verb,
      {.usage = "A B [options]",
       .text =
           {"A is a map. B is a map of the same resolution: the answer counts the cells that are "
            "in one only and those whose state or value differs. Equal means the same cells "
            "with the same values; the same map also has the same options, scans and history.",
            "A map of OctoMap (.bt, .ot) may stand for either; without --keep-free it has its "
            "occupied cells only.",
            "Or B is a cloud (.bin or .pcd) in the map's frame: the answer counts where its "
            "points lie in the map, and the cells without a point."},
       .examples = {"rmap compare street.rmap yard.rmap",
                    "rmap compare street.rmap street/truth/surface.pcd --json"}});
  add_path(verb, "A", arguments->a, "A map: .rmap, .bt or .ot.")->required();
  add_path(verb, "B", arguments->b, "Another map, or a cloud.")->required();
  verb.add_flag("--expect-equal", arguments->expect_equal,
                "Exit with 1 unless the cells of the two maps are equal.");
  arguments->octomap.add_to(verb);
  add_json_flag(verb, arguments->json);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
