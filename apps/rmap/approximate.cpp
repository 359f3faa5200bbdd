#include "arguments.hpp"
#include "cuboid_input.hpp"
#include "cuboid_report.hpp"
#include "help.hpp"
#include "map_files.hpp"
#include "output.hpp"
#include "verbs.hpp"
#include "words.hpp"

#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include <rmap/approximate.hpp>
#include <rmap/cuboid_files.hpp>
#include <rmap/error.hpp>

namespace rmap::command {

namespace {

// What stands on the command line; what does not comes from the preset.
struct ApproximateArguments {
  std::filesystem::path input;
  std::filesystem::path output;
  std::string preset = "default";
  CuboidMethod method = CuboidMethod::automatic;
  std::optional<double> resolution;
  std::optional<double> sigma;
  CuboidWeight weight = CuboidWeight::points;
  std::optional<double> omega;
  std::optional<double> outer;
  std::optional<double> inner;
  std::optional<double> max_false;
  std::optional<double> max_cuboids;
  std::optional<double> fill;
  std::string frame = "identity";
  CuboidPhase phase = CuboidPhase::zero;
  std::uint64_t max_cells = kOctomapMaxCells;
  int threads = 1;
  bool json = false;
};

int whole_number(const char* name, double value) {
  if (value != std::floor(value) || std::abs(value) > 1e6) {
    throw UsageError(fmt::format("{} is {}: it must be a whole number", name, value));
  }
  return static_cast<int>(value);
}

std::uint64_t count_argument(const char* name, double value) {
  if (!(value >= 1) || value != std::floor(value) || value > 9e15) {
    throw UsageError(fmt::format("{} is {}: it must be a whole number from 1 on", name, value));
  }
  return static_cast<std::uint64_t>(value);
}

ApproximationOptions options_of(const ApproximateArguments& arguments, bool preset_given) {
  ApproximationOptions options;
  try {
    options = approximation_preset(arguments.preset);
  } catch (const Error& error) {
    throw UsageError(error.what());
  }
  options.method = arguments.method;
  options.weight = arguments.weight;
  options.threads = arguments.threads;
  // A share alone does not say where the empty cells may lie.
  if (arguments.max_false && !arguments.outer && !preset_given) options.outer = std::nullopt;
  // An own tolerance takes the place of the share that the preset names.
  if (arguments.outer && !preset_given) options.max_false = std::nullopt;
  if (arguments.outer) options.outer = whole_number("--outer", *arguments.outer);
  if (arguments.inner) {
    options.inner = whole_number("--inner", *arguments.inner);
    if (!preset_given) options.max_false = std::nullopt;
  }
  if (arguments.max_false) options.max_false = arguments.max_false;
  if (arguments.sigma) options.sigma = *arguments.sigma;
  if (arguments.omega) options.omega = count_argument("--omega", *arguments.omega);
  if (arguments.fill) options.fill = *arguments.fill;
  if (arguments.max_cuboids) {
    options.max_cuboids = count_argument("--max-cuboids", *arguments.max_cuboids);
  }
  approximate({}, options);  // refuses what is out of range before the long work
  return options;
}

void print_answer(const ApproximateArguments& arguments, const CuboidInput& input,
                  const Approximation& approximation) {
  const ApproximationReport& report = approximation.report;
  const CuboidEvaluation evaluation = evaluate_cuboids(input.cells, approximation.cuboids);
  const CuboidError& error = evaluation.error;
  const double seconds = report.seconds_boxes + report.seconds_ranking;
  const std::string method(word_of(report.method));
  if (arguments.json) {
    Json answer{{"output", arguments.output.string()},
                {"method", method},
                {"why", report.why},
                {"preset", arguments.preset},
                {"resolution", input.resolution}};
    answer.update(json_of(error));
    answer["covered_points"] = error.points - error.lost_points;
    answer["cut"] = report.cut;
    answer["not_finite"] = input.not_finite;
    answer["beyond_limits"] = input.beyond_limits;
    answer["frame"] = json_of_frame(input.frame);
    answer["why_frame"] = input.why_frame;
    answer["phase"] = word_of(arguments.phase);
    answer["bytes"] = json_of(evaluation.bytes);
    answer["seconds"] = {{"read", input.seconds_read},
                         {"quantise", input.seconds_quantise},
                         {"frame", input.seconds_frame},
                         {"approximate", seconds}};
    answer["remarks"] = remarks(evaluation);
    print_json(answer);
    return;
  }
  std::string text = fmt::format(
      "{}: {} for {}, {:.1f} cells each\n"
      "method       {}: {}\n"
      "frame        {}: {}\n",
      arguments.output.string(), counted(error.cuboids, "cuboid"), counted(error.cells, "cell"),
      error.cuboids == 0 ? 0
                         : static_cast<double>(error.cells) / static_cast<double>(error.cuboids),
      method, report.why, readable_frame(input.frame), input.why_frame);
  text += error_lines(error);
  text += fmt::format("bytes        {} plain, {} packed\n", grouped(evaluation.bytes.plain),
                      grouped(evaluation.bytes.packed));
  text += fmt::format(
      "seconds      {:.3f} reading, {:.3f} quantising, {:.3f} frame, {:.3f} "
      "approximating\n",
      input.seconds_read, input.seconds_quantise, input.seconds_frame, seconds);
  if (input.not_finite + input.beyond_limits > 0) {
    text += fmt::format("left out     {} not finite, {} beyond the limits\n",
                        counted(input.not_finite, "point"), grouped(input.beyond_limits));
  }
  for (const std::string& remark : remarks(evaluation)) text += "note: " + remark + "\n";
  print(text);
}

void run(const ApproximateArguments& arguments, bool preset_given) {
  check_cuboid_output(arguments.output);
  const ApproximationOptions options = options_of(arguments, preset_given);
  CuboidInputOptions reading{.resolution = arguments.resolution,
                             .frame = frame_argument(arguments.frame),
                             .max_cells = arguments.max_cells,
                             .outer = options.outer.value_or(1),
                             .threads = arguments.threads};
  reading.frame.phase = arguments.phase;
  const CuboidInput input = read_cuboid_input(arguments.input, reading);
  const Approximation approximation = approximate(input.cells, options);
  write_cuboids(
      arguments.output,
      {.resolution = input.resolution, .frame = input.frame, .cuboids = approximation.cuboids});
  print_answer(arguments, input, approximation);
}

}  // namespace

void add_approximate(CLI::App& app) {
  CLI::App& verb =
      *app.add_subcommand("approximate", "Turn a map or a cloud into few rectangular cuboids.");
  const auto arguments = std::make_shared<ApproximateArguments>();
  set_help(
      verb,
      {.usage = "IN -o OUT [options]",
       .text =
           {"IN is a map (.rmap, or .bt and .ot of OctoMap), whose occupied cells are taken, a "
            "cloud "
            "(.bin, .pcd), or a folder of scans with poses. OUT is .rcs (compressed, for `rmap "
            "info` and `rmap evaluate-cuboids`), .csv or .json, a mesh to look at (.ply, .glb), or "
            "one box for each cuboid in .urdf, .sdf, .xml (MuJoCo) or .scene (MoveIt).",
            "Presets: exact: the cuboids are the cells, nothing lost or added; default: at most "
            "25 % empty cells, none farther than one cell from an occupied one; compact: the same "
            "without the share; sketch: empty cells up to two cells off, 98 % of the weight in a "
            "cuboid or next to one, and no cuboid that adds less than 4. --outer or --inner "
            "without --preset drop the share of 25 %; --max-false alone drops the limit of one "
            "cell and "
            "takes the method split. --inner is for the method cover, --fill for midpoint.",
            "Cuboids come in the order of what they add: the first N of a list are the best "
            "picture with N. The answer tells what is lost and what is false, counted cell by "
            "cell."},
       .examples = {"rmap approximate street.rmap -o street.rcs",
                    "rmap approximate street.rmap -o street.glb --preset sketch",
                    "rmap approximate street -o street.urdf --resolution 0.2 --frame estimate"}});
  add_path(verb, "IN", arguments->input, "Map, cloud, or folder of scans.", "IN")->required();
  add_path(verb, "-o,--output", arguments->output, "The file to write; its ending says what.",
           "OUT")
      ->required();
  CLI::Option* preset = verb.add_option("--preset", arguments->preset,
                                        "exact, default, compact or sketch (default: default).")
                            ->type_name("WORD")
                            ->option_text("WORD");
  add_word(verb, "--method", arguments->method,
           "auto, cover, split, runs or midpoint (default auto).");
  add_number(verb, "--resolution", arguments->resolution,
             "Edge of a cell for points, metres (default 0.1); maps have their own.");
  add_number(verb, "--outer", arguments->outer,
             "How far an empty cell of a cuboid may be from an occupied one, 0 to 3 cells.");
  add_number(verb, "--inner", arguments->inner,
             "How far an occupied cell may be from a cuboid, 0 to 3 cells.");
  add_number(verb, "--max-false", arguments->max_false,
             "Largest share of empty cells in the cuboids, 0 to below 1.");
  add_number(verb, "--sigma", arguments->sigma, "Share of the weight to cover, above 0 to 1.");
  add_word(verb, "--weight", arguments->weight,
           "What sigma and omega count: points or cells (default points; in maps each cell is "
           "one).");
  add_number(verb, "--omega", arguments->omega, "Smallest weight that a cuboid must add.");
  add_number(verb, "--max-cuboids", arguments->max_cuboids, "End of the list.");
  add_number(verb, "--fill", arguments->fill,
             "midpoint: share of occupied cells from which on a box is accepted (default 1).");
  verb.add_option("--frame", arguments->frame,
                  "Axes of the cuboids: identity, estimate, or a quaternion qx,qy,qz,qw from the "
                  "input's frame (default identity).")
      ->type_name("FRAME")
      ->option_text("FRAME");
  add_word(verb, "--phase", arguments->phase,
           "Where cells begin: zero, or centre of where points crowd (default zero).");
  add_count(verb, "--max-cells", arguments->max_cells,
            fmt::format("Most occupied cells that a map of OctoMap may have (default {}).",
                        kOctomapMaxCells));
  add_integer(verb, "--threads", arguments->threads,
              "Threads for large inputs; 0: one for each core (default 1).", 0);
  add_json_flag(verb, arguments->json);
  verb.callback([arguments, preset] { run(*arguments, preset->count() > 0); });
}

}  // namespace rmap::command
