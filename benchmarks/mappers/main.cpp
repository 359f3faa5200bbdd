// Maps of the same scans by rmap, OctoMap and a mapper on OpenVDB, in one program:
// time, memory, answers, files, and in how much they agree. `--help` says how.
#include "mappers/report.hpp"
#include "support/real_data.hpp"

#include <algorithm>
#include <exception>
#include <fstream>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <rmap/error.hpp>

namespace {

using namespace rmap::bench;

struct Arguments {
  std::vector<std::string> sequences;
  std::vector<double> resolutions{0.2, 0.1, 0.05};
  std::vector<std::string> mappers;
  std::filesystem::path data = rmap::test::data_folder();
  Share share;
  ContestOptions contest;
  double drive = 1000;
  std::filesystem::path json;
  std::filesystem::path markdown;
};

void declare(CLI::App& app, Arguments& arguments) {
  app.add_option("sequences", arguments.sequences,
                 "names of sequences (default: all, and street_simulated)");
  app.add_option("--data", arguments.data, "folder that holds sequences/NAME")
      ->capture_default_str();
  app.add_option("--resolution", arguments.resolutions, "metres")->capture_default_str();
  app.add_option("--mapper", arguments.mappers, "names of mappers beside octomap (default: all)");
  app.add_option("--scans", arguments.share.scans, "the first so many scans of each; 0: all");
  app.add_option("--stride", arguments.share.stride, "every so-manieth point of a scan")
      ->check(CLI::PositiveNumber);
  app.add_option("--repetitions", arguments.contest.repetitions, "for the clock, each mapper")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--patience", arguments.contest.patience,
                 "seconds after which a mapper is not repeated in a case; 0: endless");
  app.add_option("--drive", arguments.drive, "metres of the simulated drive; 0: none")
      ->capture_default_str();
  app.add_option("--json", arguments.json, "file for the figures");
  app.add_option("--markdown", arguments.markdown, "file for the tables");
}

// OctoMap, which the others are compared with, and those that are named.
std::vector<Contender> wanted_contenders(const std::vector<std::string>& names) {
  std::vector<Contender> all = all_contenders();
  for (const std::string& name : names) {
    if (std::none_of(all.begin(), all.end(),
                     [&](const Contender& one) { return one.name == name; })) {
      throw rmap::Error(rmap::ErrorKind::input, fmt::format("there is no mapper \"{}\"", name));
    }
  }
  if (!names.empty()) {
    std::erase_if(all, [&](const Contender& one) {
      return one.name != all.front().name &&
             std::find(names.begin(), names.end(), one.name) == names.end();
    });
  }
  return all;
}

void write(const std::filesystem::path& path, const std::string& text) {
  if (path.empty()) return;
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw rmap::Error(rmap::ErrorKind::io, fmt::format("cannot write {}", path.string()));
}

void run(const Arguments& arguments, Results& results) {
  const std::vector<Contender> contenders = wanted_contenders(arguments.mappers);
  const auto sequences = read_sequences(arguments.data, arguments.sequences, arguments.share);
  const auto save = [&] {
    write(arguments.json, to_json(results).dump(2) + "\n");
    write(arguments.markdown, to_markdown(results));
  };
  save();
  for (const double resolution : arguments.resolutions) {
    for (const Sequence& sequence : sequences) {
      fmt::print(stderr, "{} at {} m\n", sequence.name, resolution);
      results.cases.push_back(run_case(sequence, resolution, contenders, arguments.contest));
      save();
    }
  }
  if (arguments.drive > 0) {
    fmt::print(stderr, "drive of {} m\n", arguments.drive);
    results.growth.push_back(
        measure_growth(simulate_drive(arguments.drive), 0.1, arguments.contest.repetitions));
    save();
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    CLI::App app("Builds and asks maps of the same scans by several mappers, side by side.");
    Arguments arguments;
    declare(app, arguments);
    CLI11_PARSE(app, argc, argv);
    Results results{.setting = setting_of(argc, argv)};
    run(arguments, results);
    fmt::print("{}", to_markdown(results));
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "rmap_bench_mappers: {}\n", error.what());
    return 1;
  }
}
