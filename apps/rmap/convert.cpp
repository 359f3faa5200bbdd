#include "arguments.hpp"
#include "help.hpp"
#include "json.hpp"
#include "map_files.hpp"
#include "octomap_maps.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "scan_options.hpp"
#include "signals.hpp"
#include "staged_folder.hpp"
#include "verbs.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include <rmap/bag_info.hpp>
#include <rmap/cell_files.hpp>
#include <rmap/cells.hpp>
#include <rmap/crop.hpp>
#include <rmap/error.hpp>
#include <rmap/multiresolution.hpp>
#include <rmap/octomap_file.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::command {

namespace {

struct ConvertArguments {
  std::filesystem::path input;
  std::filesystem::path output;
  CellChoice cells = CellChoice::occupied;
  int coarsen = 1;
  Criterion criterion = Criterion::mean;
  std::optional<double> prune;
  std::optional<Box> crop;
  ScanEnding format = ScanEnding::bin;
  OctomapOptions octomap;
  ScanOptions reading;
  bool json = false;
  // Not every option suits every input: one without effect is refused.
  std::vector<const CLI::Option*> map_options;
  const CLI::Option* cells_option = nullptr;
  const CLI::Option* format_option = nullptr;
};

void refuse(const CLI::Option* option, const char* needed) {
  if (option->count() == 0) return;
  throw UsageError(fmt::format("{} has no effect here: {}", option->get_name(), needed));
}

AnyMap wanted_map(const ConvertArguments& arguments) {
  AnyMap map = read_any_map(arguments.input, arguments.octomap.import_options());
  Grid& grid = map.grid;
  if (arguments.crop) crop(grid, *arguments.crop);
  if (arguments.prune) grid.prune(*arguments.prune);
  if (arguments.coarsen > 1) grid = coarsen(grid, arguments.coarsen, arguments.criterion);
  return map;
}

std::uint64_t write_cell_file(const Grid& grid, CellChoice choice,
                              const std::filesystem::path& file) {
  const SignalHold hold;
  const Lattice& lattice = grid.lattice();
  return write_cells(file, [&](CellSink sink) {
    for (const auto& [cell, value] :
         cells(grid, {.occupied_only = choice == CellChoice::occupied})) {
      hold.check();
      sink({.center = lattice.center(cell),
            .size = lattice.resolution(),
            .probability = probability_of(value),
            .occupied = grid.rule().occupied(value)});
    }
  });
}

// What became of a map of OctoMap, read or written, is told where there is one.
struct Remarks {
  Json read = nullptr;
  Json written = nullptr;
  std::string words = {};
};

void report(const ConvertArguments& arguments, std::uint64_t count, const char* noun,
            const Remarks& remarks = {}) {
  if (arguments.json) {
    Json answer{{"input", arguments.input.string()},
                {"output", arguments.output.string()},
                {std::string(noun) + "s", count}};
    if (!remarks.read.is_null()) answer["read"] = remarks.read;
    if (!remarks.written.is_null()) answer["written"] = remarks.written;
    print_json(answer);
  } else {
    print(
        fmt::format("{}: {}\n{}", arguments.output.string(), counted(count, noun), remarks.words));
  }
}

OctomapExport write_octomap(const Grid& grid, const std::filesystem::path& file) {
  const SignalHold hold;
  const OctomapExport written = export_octomap(grid, file);
  hold.check();
  return written;
}

void convert_map(const ConvertArguments& arguments) {
  refuse(arguments.format_option, "it is for folders of scans");
  if (!is_octomap(arguments.input)) {
    for (const CLI::Option* option : arguments.octomap.options()) {
      refuse(option, "it is for maps of OctoMap that are read");
    }
  }
  if (arguments.crop) require_volume("--crop", *arguments.crop);
  const bool to_map = ending_of(arguments.output) == ".rmap";
  const bool to_octomap = is_octomap(arguments.output);
  if (to_map || to_octomap) {
    refuse(arguments.cells_option, "a map keeps all its cells, but those that --prune drops");
  }
  check_output_file(arguments.output);
  const AnyMap map = wanted_map(arguments);
  Remarks remarks{.read = map.json, .words = map.words};
  std::uint64_t count = map.grid.cell_count();
  if (to_map) {
    save_map(map.grid, arguments.output);
  } else if (to_octomap) {
    const OctomapExport written = write_octomap(map.grid, arguments.output);
    remarks.written = json_of(written, map.grid);
    remarks.words += words_of(written, map.grid, ending_of(arguments.output) == ".bt");
  } else {
    count = write_cell_file(map.grid, arguments.cells, arguments.output);
  }
  report(arguments, count, "cell", remarks);
}

void convert_scans(const ConvertArguments& arguments) {
  const SignalHold hold;
  const auto source = open_scans(arguments.input, arguments.reading.options());
  StagedFolder folder(arguments.output);
  check_no_scans(arguments.output);
  std::uint64_t scans = 0;
  folder.fill([&](const std::filesystem::path& staging) {
    ScanFolderWriter writer(staging, fmt::format(".{}", word_of(arguments.format)));
    Progress progress("converting", source->size());
    for (Scan scan; source->next(scan); ++scans) {
      hold.check();
      writer.add(scan);
      progress.advance();
    }
    writer.finish();
  });
  hold.check();
  folder.publish("poses.txt");
  report(arguments, scans, "scan");
}

void convert_cloud(const ConvertArguments& arguments) {
  refuse(arguments.format_option, "the ending of the output says the format");
  check_output_file(arguments.output);
  const std::vector<Vector3f> points = read_points(arguments.input, arguments.reading.options());
  const SignalHold hold;
  write_points(arguments.output, points);
  hold.check();
  report(arguments, points.size(), "point");
  const double step = coordinate_step(points);
  if (step > 0 && !arguments.json) {
    print(
        fmt::format("  note        float32 keeps the largest coordinates in steps of {:.3g} m: "
                    "--offset keeps their digits\n",
                    step));
  }
}

void refuse_output(const ConvertArguments& arguments, bool folder) {
  std::error_code missing;
  if (std::filesystem::equivalent(arguments.input, arguments.output, missing) && !missing) {
    throw Error(ErrorKind::input,
                fmt::format("{} is both input and output: the output must be another file",
                            arguments.input.string()));
  }
  const std::string ending = ending_of(arguments.output);
  const bool file =
      ending == ".rmap" || ending == ".bt" || ending == ".ot" || is_point_file(arguments.output);
  if (folder && file) {
    throw Error(ErrorKind::input,
                fmt::format("scans become a folder of scans, and the output {} is named as a file: "
                            "`rmap build` makes maps of scans",
                            arguments.output.string()));
  }
}

void run(const ConvertArguments& arguments) {
  std::error_code missing;
  const bool folder = std::filesystem::is_directory(arguments.input, missing);
  const std::string ending = ending_of(arguments.input);
  if (!folder && (ending == ".rmap" || is_octomap(arguments.input))) {
    refuse_output(arguments, false);
    return convert_map(arguments);
  }
  for (const CLI::Option* option : arguments.map_options) refuse(option, "it is for maps");
  for (const CLI::Option* option : arguments.octomap.options()) refuse(option, "it is for maps");
  refuse(arguments.cells_option, "it is for maps");
  const bool scans = folder || is_bag(arguments.input) || ending == ".graph";
  refuse_output(arguments, scans);
  if (scans) return convert_scans(arguments);
  if (is_point_file(arguments.input)) return convert_cloud(arguments);
  throw Error(
      ErrorKind::input,
      fmt::format(
          "the input {} is nothing that can be converted as far as its name says: a "
          "map (.rmap, .bt, .ot), scans (a folder, a bag, .graph) or a cloud (.pcd, .ply, .las "
          "and so on) are allowed",
          arguments.input.string()));
}

}  // namespace

void add_convert(CLI::App& app) {
  CLI::App& verb = *app.add_subcommand("convert", "Turn maps, scans and clouds into other forms.");
  const auto arguments = std::make_shared<ConvertArguments>();
  set_help(
      verb,
      {.usage = "IN OUT [options]",
       .text =
           {"A map (.rmap, or .bt and .ot of OctoMap) becomes cells for other programs: .csv "
            "(x,y,z,size,probability,state), .ply or .pcd (x y z probability); or another map "
            "(.rmap, .bt, .ot). --crop, --prune and --coarsen apply to it in this order.",
            "A .bt holds the states of cells alone, a .ot their values too; neither holds options, "
            "history and scans. Large leaves of OctoMap become the cells that they stand for, up "
            "to --max-cells.",
            "A folder of scans becomes another one with files of --format; a cloud becomes "
            ".bin or .pcd. Points alone are kept, no intensity."},
       .examples = {"rmap convert street.rmap street.ply",
                    "rmap convert street.rmap coarse.rmap --coarsen 4 --criterion max",
                    "rmap convert street.rmap street.ot",
                    "rmap convert street.ot again.rmap --keep-free",
                    "rmap convert street street_pcd --format pcd"}});
  add_path(verb, "IN", arguments->input, "Map, folder of scans or cloud.")->required();
  add_path(verb, "OUT", arguments->output, "File or folder to write; its ending says the format.")
      ->required();
  arguments->cells_option =
      add_word(verb, "--cells", arguments->cells,
               "Which cells of a map become rows or points: " + word_list<CellChoice>() +
                   " (default occupied).");
  arguments->map_options = {
      add_box(verb, "--crop", arguments->crop,
              "Keep only the cells of the map that this box x0,y0,z0,x1,y1,z1 (m) overlaps."),
      add_number(verb, "--prune", arguments->prune,
                 "Drop the cells of the map with a probability at or below, 0 to 1."),
      add_integer(verb, "--coarsen", arguments->coarsen,
                  "Make the cells of the map COUNT times as large (default 1).", 1),
      add_word(verb, "--criterion", arguments->criterion,
               "Probability of a coarse cell: " + word_list<Criterion>() +
                   " of its cells (default mean)."),
  };
  arguments->format_option =
      add_word(verb, "--format", arguments->format,
               "Files in a folder of scans: " + word_list<ScanEnding>() + " (default bin).");
  arguments->octomap.add_to(verb);
  add_json_flag(verb, arguments->json);
  arguments->reading.add_to(verb);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
