#include "mappers/report.hpp"

#include <chrono>
#include <fstream>
#include <span>
#include <string_view>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rmap::bench {

namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

nlohmann::json to_json(const Figures& figures) {
  nlohmann::json json{
      {"mapper", figures.mapper},
      {"repetitions", figures.repetitions},
      {"ns_per_beam", figures.ns_per_beam},
      {"prepare_share", figures.prepare_share},
      {"times_faster", figures.ratio},
      {"cells", figures.cells},
      {"occupied", figures.occupied},
      {"bytes", figures.bytes},
      {"peak_bytes", figures.peak_bytes},
      {"bytes_per_cell", static_cast<double>(figures.bytes) / static_cast<double>(figures.cells)}};
  if (figures.agreement) {
    json["agreement"] = {{"both", figures.agreement->both},
                         {"here_only", figures.agreement->here_only},
                         {"reference_only", figures.agreement->reference_only}};
  }
  if (figures.answers) {
    const AnswerFigures& answers = *figures.answers;
    json["answers"] = {{"iterate_ns_per_occupied_cell", answers.iterate_ns},
                       {"query_ns_per_point", answers.query_ns},
                       {"cast_ray_ns", answers.cast_ns},
                       {"save_seconds", answers.save_s},
                       {"load_seconds", answers.load_s},
                       {"file_bytes", answers.file_bytes},
                       {"equal_queries", answers.equal_queries},
                       {"equal_casts", answers.equal_casts}};
  }
  return json;
}

double mega(std::size_t bytes) { return static_cast<double>(bytes) / 1e6; }

// Three digits, whatever the size.
std::string digits(double value) {
  if (value >= 100) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}f}", value, value >= 10 ? 1 : 2);
}

std::string mappers_table(const Case& of) {
  std::string text =
      "| mapper | ns/beam | times faster | repetitions | MB in use | MB peak | bytes/cell | "
      "occupied | not in OctoMap's | only in OctoMap's |\n|---|---|---|---|---|---|---|---|---|---|"
      "\n";
  for (const Figures& figures : of.figures) {
    text += fmt::format("| {} | {} | {} | {} | {:.2f} | {:.2f} | {:.1f} | {} | {} | {} |\n",
                        figures.mapper, digits(figures.ns_per_beam), digits(figures.ratio),
                        figures.repetitions, mega(figures.bytes), mega(figures.peak_bytes),
                        static_cast<double>(figures.bytes) / static_cast<double>(figures.cells),
                        figures.occupied, figures.agreement->here_only,
                        figures.agreement->reference_only);
  }
  return text;
}

std::string answers_table(const Case& of) {
  std::string text =
      "| map | iterate, ns/occupied cell | point, ns | cast_ray, ns | file, MB | save, s | load, "
      "s | equal answers |\n|---|---|---|---|---|---|---|---|\n";
  for (const Figures& figures : of.figures) {
    if (!figures.answers) continue;
    const AnswerFigures& answers = *figures.answers;
    text += fmt::format("| {} | {} | {} | {} | {:.3f} | {:.4f} | {:.4f} | {:.3f} % |\n",
                        figures.mapper, digits(answers.iterate_ns), digits(answers.query_ns),
                        digits(answers.cast_ns), mega(answers.file_bytes), answers.save_s,
                        answers.load_s, 100 * std::min(answers.equal_queries, answers.equal_casts));
  }
  return text;
}

}  // namespace

Setting setting_of(int argc, const char* const* argv) {
  Setting setting{
      .machine = fmt::format("{}, {} cores", processor(), std::thread::hardware_concurrency()),
      .compiler = RMAP_BENCH_COMPILER,
      .rmap = RMAP_BENCH_VERSION,
      .octomap = RMAP_BENCH_OCTOMAP,
      .openvdb = RMAP_BENCH_OPENVDB,
      .date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::now())),
      .command = "rmap_bench_mappers"};
  for (const std::string_view argument :
       std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
    const char* const quote = argument.find(' ') == std::string_view::npos ? "" : "'";
    setting.command += fmt::format(" {0}{1}{0}", quote, argument);
  }
  return setting;
}

nlohmann::json to_json(const Results& results) {
  const Setting& setting = results.setting;
  nlohmann::json json{{"setting",
                       {{"machine", setting.machine},
                        {"compiler", setting.compiler},
                        {"rmap", setting.rmap},
                        {"octomap", setting.octomap},
                        {"openvdb", setting.openvdb},
                        {"date", setting.date},
                        {"command", setting.command}}},
                      {"cases", nlohmann::json::array()},
                      {"growth", nlohmann::json::array()}};
  for (const Case& each : results.cases) {
    nlohmann::json figures = nlohmann::json::array();
    for (const Figures& of : each.figures) figures.push_back(to_json(of));
    json["cases"].push_back({{"sequence", each.sequence},
                             {"scans", each.scans},
                             {"beams", each.beams},
                             {"resolution", each.resolution},
                             {"mappers", figures}});
  }
  for (const Growth& each : results.growth) {
    json["growth"].push_back({{"sequence", each.sequence},
                              {"short_cells", each.short_cells},
                              {"long_cells", each.long_cells},
                              {"short_ns_per_beam", each.short_ns},
                              {"long_ns_per_beam", each.long_ns},
                              {"ratio", each.long_ns / each.short_ns}});
  }
  return json;
}

std::string to_markdown(const Results& results) {
  const Setting& setting = results.setting;
  std::string text = fmt::format("{}, {}. rmap {}, liboctomap {}, OpenVDB {}; {}.\n\n    {}\n",
                                 setting.date, setting.machine, setting.rmap, setting.octomap,
                                 setting.openvdb.empty() ? "not built" : setting.openvdb,
                                 setting.compiler, setting.command);
  for (const Case& each : results.cases) {
    text += fmt::format("\n### {} at {} m: {} scans, {} beams\n\n{}\n{}", each.sequence,
                        each.resolution, each.scans, each.beams, mappers_table(each),
                        answers_table(each));
  }
  for (const Growth& each : results.growth) {
    text += fmt::format(
        "\n### One more scan on a {}\n\n| map before | cells | ns/beam |\n|---|---|---|\n"
        "| its last fifth but one tenth | {} | {} |\n| all of it but one tenth | {} | {} |\n\n"
        "{:.2f} times the cost.\n",
        each.sequence, each.short_cells, digits(each.short_ns), each.long_cells,
        digits(each.long_ns), each.long_ns / each.short_ns);
  }
  return text;
}

}  // namespace rmap::bench
