#include "map_options.hpp"

#include "arguments.hpp"

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap::command {

namespace {

constexpr char kMapGroup[] = "Options of the map";
constexpr char kMemoryGroup[] = "In memory (the map is the same)";

void add_memory_options(CLI::App& app, Layout& layout, int& max_branches, Split& split) {
  const LoadOptions defaults;
  add_word(app, "--layout", layout,
           fmt::format("What a leaf of the R-tree holds: {}; blocks are 8 x 8 x 8 cells, cells is "
                       "the paper's form and takes far more memory: to load a map up to some 800 "
                       "times its file, where blocks take 20 (default {}).",
                       word_list<Layout>(), word_of(defaults.layout)))
      ->group(kMemoryGroup);
  add_integer(app, "--max-branches", max_branches,
              fmt::format("M of the R-tree, 4 to 64: more takes less memory and overlaps more "
                          "(default {}).",
                          defaults.max_branches))
      ->group(kMemoryGroup);
  add_word(app, "--split", split,
           fmt::format("How a full node of the R-tree is split: {} (default {}).",
                       word_list<Split>(), word_of(defaults.split)))
      ->group(kMemoryGroup);
}

}  // namespace

void add_load_options(CLI::App& app, LoadOptions& options) {
  add_memory_options(app, options.layout, options.max_branches, options.split);
}

void MapOptions::add_to(CLI::App& app) {
  const Options defaults;
  resolution_ = add_field(app, "--resolution", &Options::resolution,
                          "Edge of a cell, metres, 1e-6 to 1e6. Required, but for --onto.");
  add_field(app, "--prob-hit", &Options::prob_hit,
            fmt::format("Probability that a cell in which a beam ended is occupied: above the "
                        "prior, below 1 (default {}).",
                        defaults.prob_hit));
  add_field(app, "--prob-miss", &Options::prob_miss,
            fmt::format("Probability that a cell which a beam crossed is occupied: above 0, below "
                        "the prior (default {}).",
                        defaults.prob_miss));
  add_field(app, "--clamp-min", &Options::clamp_min,
            fmt::format("Least probability of a cell: above 0, below the prior (default {}).",
                        defaults.clamp_min));
  add_field(app, "--clamp-max", &Options::clamp_max,
            fmt::format("Largest probability of a cell: above the prior, below 1 (default {}).",
                        defaults.clamp_max));
  add_field(app, "--prior", &Options::prior,
            fmt::format("Probability of a cell before anything is known of it (default {}).",
                        defaults.prior));
  add_field(app, "--occupied-threshold", &Options::occupied_threshold,
            fmt::format("A cell is occupied when its probability is above: prior to below 1 "
                        "(default {}).",
                        defaults.occupied_threshold));
  add_field(app, "--free-probability", &Options::free_probability,
            fmt::format("What a cell that does not exist counts in a box: 0 to 1 (default {}).",
                        defaults.free_probability));
  add_field(app, "--saturation", &Options::saturation,
            fmt::format("What happens to a cell at a limit: {}; clamp lets it come back, freeze "
                        "never changes it again (default {}).",
                        word_list<Saturation>(), word_of(defaults.saturation)));
  add_field(app, "--min-range", &Options::min_range,
            fmt::format("Points nearer to the sensor are skipped, metres (default {}).",
                        defaults.min_range));
  add_field(app, "--max-range", &Options::max_range,
            "Longer beams are cut there, metres: they clear, but end in no cell (default inf).");
  add_field(app, "--beams", &Options::beams,
            fmt::format("Which beams clear: {}; per_end_cell is an approximation for dense depth "
                        "images (default {}).",
                        word_list<Beams>(), word_of(defaults.beams)));

  add_memory_options(app, options_.layout, options_.max_branches, options_.split);
  add_integer(
      app, "--threads", options_.threads,
      fmt::format("Threads to work with; 0: one for each core (default {}).", defaults.threads))
      ->group(kMemoryGroup);
  add_word(app, "--traversal", options_.traversal,
           fmt::format("How crossed cells are found: {}; the map is the same (default {}).",
                       word_list<Traversal>(), word_of(defaults.traversal)))
      ->group(kMemoryGroup);
  add_word(app, "--bad-points", options_.bad_points,
           fmt::format("What becomes of points that are not finite or beyond what a map can hold: "
                       "{} (default {}).",
                       word_list<BadPoints>(), word_of(defaults.bad_points)));
}

CLI::Option* MapOptions::add_field(CLI::App& app, const char* name, double Options::*field,
                                   const std::string& help) {
  CLI::Option* option = add_number(app, name, options_.*field, help)->group(kMapGroup);
  fields_.push_back(
      {option, [field](const Options& options) { return fmt::format("{}", options.*field); }});
  return option;
}

template <class Enum>
void MapOptions::add_field(CLI::App& app, const char* name, Enum Options::*field,
                           const std::string& help) {
  const CLI::Option* option = add_word(app, name, options_.*field, help)->group(kMapGroup);
  fields_.push_back(
      {option, [field](const Options& options) { return std::string(word_of(options.*field)); }});
}

LoadOptions MapOptions::load_options() const {
  return {.layout = options_.layout,
          .max_branches = options_.max_branches,
          .split = options_.split,
          .bad_points = options_.bad_points,
          .traversal = options_.traversal,
          .threads = options_.threads};
}

void MapOptions::require_agreement(const Options& of_map, const std::filesystem::path& file) const {
  for (const Field& field : fields_) {
    // The shortest text that gives a number back: equal texts are equal values.
    const std::string ours = field.text(options_);
    const std::string theirs = field.text(of_map);
    if (field.option->count() > 0 && ours != theirs) {
      throw Error(ErrorKind::input,
                  fmt::format("{} is {}, but the map {} was made with {}: leave the option out to "
                              "go on with that map",
                              field.option->get_name(), ours, file.string(), theirs));
    }
  }
}

}  // namespace rmap::command
