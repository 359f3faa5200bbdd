#include "arguments.hpp"
#include "build_report.hpp"
#include "help.hpp"
#include "map_files.hpp"
#include "map_options.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "scan_options.hpp"
#include "stopwatch.hpp"
#include "verbs.hpp"

#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/grid.hpp>
#include <rmap/map_file.hpp>
#include <rmap/scan_filter.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::command {

namespace {

struct BuildArguments {
  std::vector<std::filesystem::path> scans;
  std::filesystem::path output;
  std::filesystem::path onto;
  MapOptions map;
  ScanOptions reading;
  History history = History::complete;
  ScanFilter filter;
  int every = 1;
  bool dry_run = false;
  bool json = false;
};

// The scans that are asked for, without the points that are not.
class WantedScans {
 public:
  explicit WantedScans(const BuildArguments& arguments)
      : source_(read_ahead(open_scan_sequence(arguments.scans, arguments.reading.options()))),
        filter_(arguments.filter),
        every_(static_cast<std::size_t>(arguments.every)) {}

  std::optional<std::size_t> size() const {
    const auto all = source_->size();
    return all ? std::optional((*all + every_ - 1) / every_) : std::nullopt;
  }

  void rewind() {
    source_->rewind();
    index_ = 0;
    points_ = 0;
    left_out_ = {};
  }

  /// Reads the next one; throws as ScanSource::next and can go on after it.
  bool next(Scan& scan) {
    for (;;) {
      const std::size_t index = index_++;
      if (!source_->next(scan)) return false;
      if (index % every_ == 0) break;
    }
    points_ += scan.points.size() + scan.no_returns.size();
    filter_.apply(scan, left_out_);
    return true;
  }

  /// Of the pass that is over.
  ScanNotes notes() const { return source_->notes(); }
  /// What this pass has met so far.
  std::uint64_t points() const { return points_; }
  const ScanFilter::Counts& left_out() const { return left_out_; }

 private:
  std::unique_ptr<ScanSource> source_;
  ScanFilter filter_;
  std::size_t every_;
  std::size_t index_ = 0;
  std::uint64_t points_ = 0;
  ScanFilter::Counts left_out_;
};

Grid starting_grid(const BuildArguments& arguments) {
  if (arguments.onto.empty()) return Grid(arguments.map.options());
  Grid grid = load_map(arguments.onto, arguments.map.load_options());
  arguments.map.require_agreement(grid.options(), arguments.onto);
  return grid;
}

// First every end cell of every scan exists, then the scans come in order: so each cell
// sees all its misses. --history first_hit is the second pass alone.
BuildReport insert_all(Grid& grid, WantedScans& scans, History history) {
  BuildReport report;
  Stopwatch watch;
  Scan scan;
  if (history == History::complete) {
    Progress progress("preparing", scans.size());
    while (scans.next(scan)) {
      report.seconds_read += watch.lap();
      report.prepared_cells += grid.prepare(scan).new_cells;
      report.seconds_prepare += watch.lap();
      progress.advance();
    }
    scans.rewind();
  }
  Progress progress("inserting", scans.size());
  while (scans.next(scan)) {
    report.seconds_read += watch.lap();
    report.inserted += grid.insert(scan);
    report.seconds_insert += watch.lap();
    ++report.scans;
    progress.advance();
  }
  report.points = scans.points();
  report.left_out = scans.left_out();
  report.notes = scans.notes();
  return report;
}

// A map of nothing is no answer, and must not take the place of one.
void require_effect(const BuildReport& report) {
  if (report.scans == 0) {
    std::string why;
    for (const std::string& warning : report.notes.warnings) why += "; " + warning;
    throw Error(ErrorKind::input,
                fmt::format("there is no scan to build from, and nothing was written{}", why));
  }
  if (report.inserted.inserted + report.inserted.cut > 0) return;
  throw Error(
      ErrorKind::input,
      fmt::format("none of the {} of {} has an effect, and nothing was written; skipped: {}",
                  counted(report.points, "point"), counted(report.scans, "scan"),
                  words_of(report.inserted.skipped, report.left_out)));
}

// Each scan meets a map of its own, so that memory stays that of one scan.
CheckReport check_all(const Options& options, WantedScans& scans) {
  CheckReport report;
  Progress progress("checking", scans.size());
  Scan scan;
  for (bool more = true; more; progress.advance()) {
    try {
      more = scans.next(scan);
      if (!more) break;
      ++report.scans;
      report.skipped += Grid(options).prepare(scan).skipped;
    } catch (const Error& error) {
      report.problems.emplace_back(error.what());
    }
  }
  report.points = scans.points();
  report.left_out = scans.left_out();
  report.notes = scans.notes();
  return report;
}

void run_check(const BuildArguments& arguments) {
  const Options options = starting_grid(arguments).options();
  WantedScans scans(arguments);
  const CheckReport report = check_all(options, scans);
  if (arguments.json) {
    print_json(json_of(report));
  } else {
    print(words_of(report));
    for (const std::string& problem : report.problems) print("problem: " + problem + "\n");
  }
  if (!report.problems.empty()) {
    throw Error(ErrorKind::input,
                fmt::format("the check found {}, the first of them: {}",
                            counted(report.problems.size(), "problem"), report.problems.front()));
  }
}

void run(const BuildArguments& arguments) {
  if (arguments.onto.empty() && !arguments.map.resolution_given()) {
    throw UsageError(
        "--resolution is missing: a new map needs the edge of its cells, in metres (see rmap build "
        "--help)");
  }
  if (arguments.filter.crop) require_volume("--crop", *arguments.filter.crop);
  for (const Box& box : arguments.filter.ignore) require_volume("--ignore", box);
  if (arguments.dry_run) return run_check(arguments);
  if (arguments.output.empty()) {
    throw UsageError("-o is missing: the map needs a name (see rmap build --help)");
  }
  check_map_output(arguments.output);

  Grid grid = starting_grid(arguments);
  WantedScans scans(arguments);
  BuildReport report = insert_all(grid, scans, arguments.history);
  require_effect(report);
  Stopwatch watch;
  save_map(grid, arguments.output);
  report.seconds_save = watch.lap();

  const BuiltMap map{.output = arguments.output,
                     .cells = grid.cell_count(),
                     .occupied = occupied_count(grid),
                     .history = grid.history(),
                     .bytes_in_use = grid.bytes_in_use()};
  if (arguments.json) {
    print_json(json_of(report, map));
  } else {
    print(words_of(report, map));
  }
}

}  // namespace

void add_build(CLI::App& app) {
  CLI::App& verb = *app.add_subcommand("build", "Make a map of scans with poses.");
  const auto arguments = std::make_shared<BuildArguments>();
  set_help(
      verb,
      {.usage = "SCANS... -o MAP --resolution METRES [options]",
       .text =
           {"A folder of scans holds .bin files (KITTI: float32 x y z intensity), or .pcd, .ply, "
            ".las, .xyz, .csv files in the sensor's frame, and poses.txt with one pose a line, "
            "sensor to map: 12 numbers (3x4 matrix by rows), 16, 7 (tx ty tz qx qy qz qw) or 8 "
            "(time first). Folders of 3DTK (.3d, .pose) and KITTI (velodyne, calib.txt) come as "
            "they are; so do OctoMap's .graph and bags (.mcap, .db3, folders of rosbag2). One file "
            "of a folder is that scan alone. Several SCANS follow one another.",
            "A lone file has to say where its beams began: with a pose or origins in it, or "
            "--sensor-origin, --sensor-pose or --end-points.",
            "The map does not depend on the order of points in a scan, --threads or --layout. "
            "Points that had no effect are counted by reason: points = inserted + cut + skipped.",
            "A box (BOX) is six numbers x0,y0,z0,x1,y1,z1 in metres."},
       .examples = {
           "rmap build street -o street.rmap --resolution 0.1",
           "rmap build street -o near.rmap --resolution 0.05 --max-range 20 --ignore "
           "-1,-1,-2,1,1,1",
           "rmap build street/truth/surface.pcd -o surface.rmap --resolution 0.1 --end-points"}});
  add_paths(verb, "SCANS", arguments->scans, "Folders of scans, single scans, bags.")->required();
  add_path(verb, "-o,--output", arguments->output,
           "The map to write, ending in .rmap. Required, but for --dry-run.");
  add_word(verb, "--history", arguments->history,
           "Which misses the cells see: complete reads the scans twice, first to make all cells; "
           "first-hit is a live robot's single pass, and leaves more cells occupied (default "
           "complete).");
  add_path(verb, "--onto", arguments->onto,
           "Go on with this map: its options stand, and another value for one is an error. Its "
           "history is complete only if no new cell was made after its first scan.");
  add_integer(verb, "--every", arguments->every,
              "Take the first scan of every COUNT scans (default 1: all).", 1);
  add_box(verb, "--crop", arguments->filter.crop,
          "Map's frame: leave out points outside, with their beams.");
  add_boxes(verb, "--ignore", arguments->filter.ignore,
            "Sensor's frame: leave out points inside, with their beams, as those on the robot "
            "itself; may be given several times.");
  verb.add_flag(
      "--dry-run", arguments->dry_run,
      "Read and check everything, write nothing; tells all problems, not only the first.");
  add_json_flag(verb, arguments->json);
  arguments->reading.add_to(verb);
  arguments->map.add_to(verb);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
