#include "octomap_maps.hpp"

#include "arguments.hpp"
#include "words.hpp"

#include <fmt/format.h>

#include <rmap/map_file.hpp>
#include <rmap/scan_files.hpp>

namespace rmap::command {

namespace {

constexpr char kGroup[] = "For maps of OctoMap";

Json json_of_import(const OctomapImport& import) {
  return {{"id", import.file.id},
          {"nodes", import.file.nodes},
          {"occupied_leaves", import.file.occupied_leaves},
          {"free_leaves", import.file.free_leaves},
          {"dropped_free_leaves", import.dropped_free_leaves},
          {"clamped_leaves", import.clamped_leaves},
          {"changed_leaves", import.changed_leaves},
          {"colors_dropped", import.file.colors},
          {"states_only", import.file.states_only}};
}

std::string words_of_import(const OctomapImport& import) {
  const OctomapInfo& file = import.file;
  std::string words =
      fmt::format("  read        {} of {} m: {} occupied and {} free leaves\n", file.id,
                  file.resolution, grouped(file.occupied_leaves), grouped(file.free_leaves));
  if (import.dropped_free_leaves > 0) {
    words += fmt::format("  dropped     {} free leaves: free space is implicit (--keep-free)\n",
                         grouped(import.dropped_free_leaves));
  }
  if (file.states_only) {
    words += fmt::format("  values      the limits {} and {}: the file holds states only\n",
                         import.grid.options().clamp_min, import.grid.options().clamp_max);
  }
  if (file.colors) words += "  colours     dropped\n";
  if (import.clamped_leaves > 0) {
    words += fmt::format("  clamped     values of {} leaves to {} ... {}\n",
                         grouped(import.clamped_leaves), import.grid.options().clamp_min,
                         import.grid.options().clamp_max);
  }
  if (import.changed_leaves > 0) {
    words += fmt::format("  changed     states of {} leaves: the threshold {} is not OctoMap's\n",
                         grouped(import.changed_leaves), import.grid.options().occupied_threshold);
  }
  return words;
}

}  // namespace

bool is_octomap(const std::filesystem::path& file) {
  const std::string ending = ending_of(file);
  return ending == ".bt" || ending == ".ot";
}

void OctomapOptions::add_to(CLI::App& app) {
  options_ = {
      app.add_flag("--keep-free", import_.keep_free,
                   "Cells of free leaves exist in the map; else they are dropped and counted."),
      add_count(
          app, "--max-cells", import_.max_cells,
          fmt::format("Most cells that the leaves may become (default {}).", kOctomapMaxCells)),
      add_number(app, "--clamp-min", clamp_min_,
                 fmt::format("Least probability of a cell, free ones of a .bt get it (default {}).",
                             import_.map.clamp_min)),
      add_number(
          app, "--clamp-max", clamp_max_,
          fmt::format("Largest probability of a cell, occupied ones of a .bt get it (default {}).",
                      import_.map.clamp_max)),
      add_number(app, "--occupied-threshold", occupied_threshold_,
                 fmt::format("A cell of the map is occupied above this probability (default {}).",
                             import_.map.occupied_threshold)),
  };
  for (const CLI::Option* option : options_) app.get_option(option->get_name())->group(kGroup);
}

OctomapImportOptions OctomapOptions::import_options() const {
  OctomapImportOptions options = import_;
  if (clamp_min_) options.map.clamp_min = *clamp_min_;
  if (clamp_max_) options.map.clamp_max = *clamp_max_;
  if (occupied_threshold_) options.map.occupied_threshold = *occupied_threshold_;
  return options;
}

AnyMap read_any_map(const std::filesystem::path& file, const OctomapImportOptions& options) {
  if (!is_octomap(file)) return {.grid = load(file)};
  OctomapImport import = import_octomap(file, options);
  Json json = json_of_import(import);
  std::string words = words_of_import(import);
  return {.grid = std::move(import.grid), .json = std::move(json), .words = std::move(words)};
}

Json json_of(const OctomapExport& report, const Grid& grid) {
  return {{"nodes", report.nodes},
          {"occupied_cells", report.occupied_cells},
          {"free_cells", report.free_cells},
          {"lost_values", report.lost_values},
          {"changed_states", report.changed_states},
          {"lost_scans", grid.scan_poses().size()}};
}

std::string words_of(const OctomapExport& report, const Grid& grid, bool states_only) {
  std::string words =
      fmt::format("  nodes       {} for {} occupied and {} free cells\n", grouped(report.nodes),
                  grouped(report.occupied_cells), grouped(report.free_cells));
  words += "  lost        options, history";
  if (!grid.scan_poses().empty()) {
    words += fmt::format(", poses of {}", counted(grid.scan_poses().size(), "scan"));
  }
  if (states_only) words += fmt::format(", values of {}", counted(report.lost_values, "cell"));
  words += "\n";
  if (report.changed_states > 0) {
    words += fmt::format(
        "  changed     OctoMap takes {} for occupied or free where the map does "
        "not: its threshold is 0.5, the map's {}\n",
        counted(report.changed_states, "cell"), grid.options().occupied_threshold);
  }
  return words;
}

}  // namespace rmap::command
