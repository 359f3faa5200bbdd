#include "arguments.hpp"
#include "help.hpp"
#include "json.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "scan_options.hpp"
#include "verbs.hpp"

#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <rmap/cuboid_files.hpp>
#include <rmap/error.hpp>
#include <rmap/map_repair.hpp>
#include <rmap/octomap_file.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::command {

namespace {

struct ValidateArguments {
  std::vector<std::filesystem::path> files;
  ScanOptions reading;
  bool json = false;
};

using Problems = std::vector<MapProblem>;

// More than anybody reads; a source that is no more than errors then ends too.
constexpr std::size_t kMostProblems = 1000;

// What read() refuses, if anything.
template <class Read>
Problems problem_of(Read&& read) {
  try {
    read();
    return {};
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::usage) throw;
    return {{.sentence = error.what()}};
  }
}

// Each scan that cannot be read, not only the first.
Problems check_scans(const std::filesystem::path& path, const ScanReadOptions& reading) {
  const auto source = open_scans(path, reading);
  Problems problems;
  Progress progress("checking", source->size());
  Scan scan;
  for (bool more = true; more && problems.size() < kMostProblems; progress.advance()) {
    try {
      more = source->next(scan);
    } catch (const Error& error) {
      problems.push_back({.sentence = error.what()});
    }
  }
  // What is read all the same is not as it should be either: a recording that is cut off, say.
  ScanNotes notes = source->notes();
  for (std::string& warning : notes.warnings) {
    problems.push_back({.sentence = std::move(warning)});
  }
  return problems;
}

// A table may hold something else or points.
template <class Read>
Problems check_rows(const std::filesystem::path& file, const ScanReadOptions& reading, Read&& read,
                    std::string_view what) {
  const Problems as_that = problem_of(read);
  if (as_that.empty()) return {};
  const Problems as_points = problem_of([&] { read_points(file, reading); });
  if (as_points.empty()) return {};
  return {{.sentence = fmt::format("as {}: {}; as points: {}", what, as_that.front().sentence,
                                   as_points.front().sentence)}};
}

Problems check_by_name(const std::filesystem::path& file, const ScanReadOptions& reading) {
  std::error_code missing;
  if (std::filesystem::is_directory(file, missing)) return check_scans(file, reading);
  const std::string ending = ending_of(file);
  if (ending == ".rmap") return check_map_file(file);
  if (ending == ".bt" || ending == ".ot") return problem_of([&] { read_octomap_info(file); });
  if (ending == ".rcs") return problem_of([&] { read_cuboids(file); });
  if (ending == ".csv") {
    const auto read = [&] { read_cuboids(file); };
    return check_rows(file, reading, read, "cuboids");
  }
  if (ending == ".txt") {
    const auto read = [&] { read_poses(file); };
    return check_rows(file, reading, read, "poses");
  }
  if (is_point_file(file)) return problem_of([&] { read_points(file, reading); });
  return check_scans(file, reading);
}

// A file that cannot be opened is a problem like others: those behind it are still looked at.
Problems check(const std::filesystem::path& file, const ScanReadOptions& reading) {
  try {
    return check_by_name(file, reading);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::usage) throw;
    return {{.sentence = error.what()}};
  }
}

Json json_of(const std::filesystem::path& file, const Problems& problems) {
  Json list = Json::array();
  for (const MapProblem& problem : problems) {
    list.push_back({{"sentence", problem.sentence},
                    {"chunk", problem.chunk.empty() ? Json(nullptr) : Json(problem.chunk)},
                    {"offset", problem.offset ? Json(*problem.offset) : Json(nullptr)},
                    {"size", problem.offset ? Json(problem.size) : Json(nullptr)}});
  }
  return {{"file", file.string()}, {"sound", problems.empty()}, {"problems", list}};
}

std::string words_of(const std::filesystem::path& file, const Problems& problems) {
  if (problems.empty()) return fmt::format("{}: sound\n", file.string());
  std::string words = fmt::format("{}: {}\n", file.string(), counted(problems.size(), "problem"));
  for (const MapProblem& problem : problems) words += "  " + problem.sentence + "\n";
  return words;
}

void run(const ValidateArguments& arguments) {
  const ScanReadOptions reading = arguments.reading.options();
  Json answers = Json::array();
  std::size_t wrong = 0;
  std::string first;
  for (const std::filesystem::path& file : arguments.files) {
    const Problems problems = check(file, reading);
    if (!problems.empty() && wrong++ == 0) first = problems.front().sentence;
    if (arguments.json) {
      answers.push_back(json_of(file, problems));
    } else {
      print(words_of(file, problems));
    }
  }
  if (arguments.json) print_json(answers.size() == 1 ? answers.front() : answers);
  if (wrong > 0) {
    throw Error(
        ErrorKind::input,
        fmt::format("{} of {} not sound, the first problem: {}", wrong,
                    arguments.files.size() == 1 ? "1 file is"
                                                : counted(arguments.files.size(), "file") + " are",
                    first));
  }
}

}  // namespace

void add_validate(CLI::App& app) {
  CLI::App& verb = *app.add_subcommand("validate", "Tell what is wrong with files, and where.");
  const auto arguments = std::make_shared<ValidateArguments>();
  set_help(
      verb,
      {.usage = "FILE... [options]",
       .text = {"Reads all of a file as the other verbs would and tells what they would refuse: of "
                "a map (.rmap) each damaged chunk with its type and place, of all that holds "
                "scans each one that cannot be read and what there is to warn of, of other files "
                "(.bt, .ot, .rcs, .csv, .bin, .pcd) the first thing that is wrong. Exits with 1 "
                "when anything is."},
       .examples = {"rmap validate street.rmap", "rmap validate street street.rmap --json"}});
  add_paths(verb, "FILE", arguments->files, "Maps, clouds, folders of scans, cuboids.")->required();
  add_json_flag(verb, arguments->json);
  arguments->reading.add_to(verb);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
