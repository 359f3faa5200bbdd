#include "arguments.hpp"
#include "evaluation/evaluation.hpp"
#include "evaluation/machine.hpp"
#include "evaluation/map_under_test.hpp"
#include "help.hpp"
#include "json.hpp"
#include "output.hpp"
#include "scan_options.hpp"
#include "signals.hpp"
#include "staged_folder.hpp"
#include "verbs.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::command {

namespace {

constexpr char kResultsFile[] = "results.json";
// What --quick takes of the simulated sequence: a stretch of it, not a thinner one.
constexpr int kQuickScans = 40;
constexpr double kQuickResolution = 0.2;

struct EvaluateArguments {
  std::vector<std::filesystem::path> scans;
  std::vector<std::filesystem::path> clouds;
  std::filesystem::path output;
  std::optional<std::string> experiments;
  std::optional<std::string> resolutions;
  ScanOptions reading;
  int most_scans = 0;
  int repetitions = 3;
  double lift = evaluation::kLift;
  std::uint64_t seed = 0;
  bool quick = false;
  bool json = false;
};

std::set<std::string> experiments_of(const std::string& text) {
  std::set<std::string> experiments;
  const std::vector<std::string>& names = evaluation::experiment_names();
  for (const std::string& name : split_at_commas(text)) {
    if (std::find(names.begin(), names.end(), name) == names.end()) {
      throw UsageError(fmt::format("--experiments names \"{}\": the experiments are {}", name,
                                   fmt::join(names, ", ")));
    }
    experiments.insert(name);
  }
  return experiments;
}

std::vector<double> resolutions_of(const std::string& text) {
  std::vector<double> resolutions;
  for (const std::string& part : split_at_commas(text)) {
    const auto number = parse_number(part);
    if (!number) {
      throw UsageError(
          fmt::format("--resolution is \"{}\": it must be numbers of metres, "
                      "separated by commas",
                      text));
    }
    resolutions.push_back(Lattice(*number).resolution());
  }
  return resolutions;
}

// A folder that ends in "/" has its name before it.
std::string name_of(const std::filesystem::path& path) {
  const std::string name = path.filename().string();
  return name.empty() ? path.parent_path().filename().string() : name;
}

std::vector<evaluation::Sequence> sequences_of(const EvaluateArguments& arguments) {
  std::vector<evaluation::Sequence> sequences;
  const auto most = static_cast<std::size_t>(arguments.most_scans);
  if (arguments.scans.empty()) {
    sequences.push_back(evaluation::campus_sequence(
        most == 0 && arguments.quick ? kQuickScans : most, arguments.lift, arguments.seed));
  }
  for (const std::filesystem::path& path : arguments.scans) {
    const auto source = open_scans(path, arguments.reading.options());
    sequences.push_back(evaluation::read_sequence(name_of(path), *source, most));
  }
  return sequences;
}

// A hundredth of a cloud's longest edge: some thousand cells on its surface.
double resolution_for(const std::filesystem::path& file, const std::vector<Vector3f>& points) {
  Eigen::AlignedBox3f box;
  for (const Vector3f& point : points) {
    if (point.allFinite()) box.extend(point);
  }
  if (box.isEmpty() || box.sizes().maxCoeff() <= 0) {
    throw Error(ErrorKind::input,
                fmt::format("{} holds no two points that differ: it cannot be approximated",
                            file.string()));
  }
  return double(box.sizes().maxCoeff()) / 100;
}

std::vector<evaluation::CloudScene> clouds_of(const EvaluateArguments& arguments) {
  std::vector<evaluation::CloudScene> clouds;
  if (arguments.scans.empty()) clouds = evaluation::simulated_clouds(arguments.seed);
  for (const std::filesystem::path& file : arguments.clouds) {
    std::vector<Vector3f> points = read_points(file, arguments.reading.options());
    const double resolution = resolution_for(file, points);
    clouds.push_back({file.stem().string(), name_of(file), resolution, std::move(points)});
  }
  return clouds;
}

evaluation::EvaluationOptions options_of(const EvaluateArguments& arguments) {
  evaluation::EvaluationOptions options;
  options.repetitions = arguments.quick ? 1 : arguments.repetitions;
  options.is_campus = arguments.scans.empty();
  if (arguments.experiments) options.experiments = experiments_of(*arguments.experiments);
  if (arguments.quick) options.resolutions = {kQuickResolution};
  if (arguments.resolutions) options.resolutions = resolutions_of(*arguments.resolutions);
  return options;
}

// As a shell takes it for one word.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./,:=+";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char character : word) {
    quoted += character == '\'' ? std::string("'\\''") : std::string(1, character);
  }
  return quoted + "'";
}

// The command that gives these results again: all that was given, whichever option it is.
std::string command_line(const CLI::App& verb) {
  std::string line = "rmap evaluate";
  for (const CLI::Option* option : verb.get_options()) {
    if (option->count() == 0 || option->check_name("--json")) continue;
    if (option->get_items_expected_max() == 0) {
      line += " " + option->get_name();
      continue;
    }
    const std::string name = option->get_positional() ? "" : option->get_name() + " ";
    for (const std::string& value : option->results()) line += " " + name + quoted(value);
  }
  return line;
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) {
    throw Error(ErrorKind::io, fmt::format("cannot write {}: {}", file.string(),
                                           std::generic_category().message(errno)));
  }
}

// What is being done, on a line of its own, to who watches.
void tell(const std::string& what) {
  if (!error_is_terminal()) return;
  fmt::print(stderr, "{}\n", what);
}

void print_summary(const EvaluateArguments& arguments, const evaluation::Evaluation& result) {
  std::size_t judged = 0;
  std::size_t failed = 0;
  for (const evaluation::Check& check : result.checks) {
    if (!check.judged) continue;
    ++judged;
    if (!check.holds) ++failed;
  }
  std::string text = fmt::format("{}: {} of {}\n", arguments.output.string(), kResultsFile,
                                 counted(result.sequences.size(), "sequence"));
  if (evaluation::octomap_version().empty()) {
    text += "  octomap     not built in: its columns are missing\n";
  }
  text += fmt::format("  checks      {} judged, {} of them not shown\n", judged, failed);
  for (const evaluation::Check& check : result.checks) {
    if (check.holds || !check.judged) continue;
    text += fmt::format("  not shown   {} [{}]: {}\n", check.claim, check.subject, check.shown);
  }
  print(text);
}

void run(const EvaluateArguments& arguments, const CLI::App& verb) {
  if (arguments.output.empty()) {
    throw UsageError("-o is missing: the results need a folder (see rmap evaluate --help)");
  }
  const evaluation::EvaluationOptions options = options_of(arguments);
  if (std::filesystem::exists(arguments.output / kResultsFile)) {
    throw Error(ErrorKind::input, fmt::format("{} holds {} already: name another folder",
                                              arguments.output.string(), kResultsFile));
  }
  const std::vector<evaluation::Sequence> sequences = sequences_of(arguments);
  const std::vector<evaluation::CloudScene> clouds = clouds_of(arguments);
  // A folder that cannot be written is refused here, not after the long work.
  { const StagedFolder trial(arguments.output); }
  const evaluation::Evaluation result = evaluation::evaluate(sequences, clouds, options, tell);
  const SignalHold hold;
  StagedFolder folder(arguments.output);
  Json document{{"command", command_line(verb)},
                {"seed", arguments.seed},
                {"quick", arguments.quick},
                {"machine", evaluation::describe_machine()}};
  document.update(evaluation::to_json(result));
  folder.fill([&](const std::filesystem::path& staging) {
    for (const auto& [name, text] : evaluation::tables_of(result)) {
      write_text(staging / name, text);
    }
    write_text(staging / kResultsFile, text_of(document));
  });
  hold.check();
  folder.publish(kResultsFile);
  if (arguments.json) {
    print_json(document);
  } else {
    print_summary(arguments, result);
  }
}

}  // namespace

void add_evaluate(CLI::App& app) {
  CLI::App& verb = *app.add_subcommand("evaluate", "Repeat the paper's experiments.");
  const auto arguments = std::make_shared<EvaluateArguments>();
  set_help(
      verb,
      {.usage = "[SCANS...] -o FOLDER [options]",
       .text =
           {"The experiments are " +
                fmt::format("{}", fmt::join(evaluation::experiment_names(), ", ")) +
                ": R-trees by order, split and loading; maps scan by scan in both layouts beside "
                "OctoMap; accuracy on every 5th scan, held out; what a single pass costs; query "
                "cuboids fine near and coarse far; cuboids by sigma and omega.",
            "Without SCANS they run on the simulated campus, 70 scans of up to 50 m, a noisy room "
            "and a sphere. Each of SCANS, as `rmap build` takes them, is a sequence of its own, "
            "and is held in memory.",
            "FOLDER gets results.json, with machine, versions and command, and the tables as "
            ".csv. `scripts/repeat-paper` makes a report of it. Without OctoMap at build time its "
            "columns are missing."},
       .examples = {"rmap evaluate --quick --scans 6 --experiments accuracy,history -o evaluated",
                    "rmap evaluate street -o street_evaluated --scans 2 --resolution 0.4"}});
  add_paths(verb, "SCANS", arguments->scans, "Folders of scans, single scans, bags.");
  add_path(verb, "-o,--output", arguments->output,
           "Folder for the results; made where it is missing.", "FOLDER");
  add_paths(verb, "--cloud", arguments->clouds,
            "Clouds that are approximated by cuboids too, in cells of a hundredth of their size.");
  add_text(verb, "--experiments", arguments->experiments, "LIST",
           "Those wanted, separated by commas (default all).");
  add_text(verb, "--resolution", arguments->resolutions, "LIST",
           "Edges of cells, metres, separated by commas (default 0.1,0.2; --quick 0.2). Accuracy "
           "is taken at the coarsest, R-trees and cuboids at the finest.");
  add_integer(verb, "--scans", arguments->most_scans,
              "Take the first so many scans of each sequence (default all; --quick 40 of the "
              "simulated one).",
              1);
  add_integer(verb, "--repetitions", arguments->repetitions,
              "Of what is short enough to be repeated (default 3; --quick 1).", 1);
  add_number(verb, "--lift", arguments->lift,
             "Metres that the simulated campus is lifted by: where its ground, at 0.0033, lies in "
             "its layer of cells (default -0.0133, just under a border).");
  add_seed(verb, "--seed", arguments->seed,
           "Seed of the simulated clouds (default 0); the campus is without chance.");
  verb.add_flag("--quick", arguments->quick,
                "Little of everything, within two minutes: the shape of the findings.");
  add_json_flag(verb, arguments->json);
  arguments->reading.add_to(verb);
  verb.callback([arguments, &verb] { run(*arguments, verb); });
}

}  // namespace rmap::command
