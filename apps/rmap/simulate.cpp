#include "arguments.hpp"
#include "help.hpp"
#include "output.hpp"
#include "progress.hpp"
#include "signals.hpp"
#include "staged_folder.hpp"
#include "truth.hpp"
#include "verbs.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/simulation.hpp>

namespace rmap::command {

namespace {

constexpr double kSurfaceSpacing = 0.1;  // metres
constexpr char kSurfaceFile[] = "truth/surface.pcd";
constexpr char kTruthFile[] = "truth.json";

struct SimulateArguments {
  std::string scene;
  std::filesystem::path output;
  int scans = 0;
  std::string sensor;
  std::optional<double> noise;
  double dropped = 0;
  std::uint64_t seed = 0;
  ScanEnding ending = ScanEnding::bin;
  double spacing = kSurfaceSpacing;
  bool list = false;
  bool json = false;
};

std::string joined(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

void list_scenes(bool json) {
  Json scenes = Json::array();
  for (const std::string& name : scene_names()) {
    const Simulation simulation = make_simulation(name);
    if (json) {
      scenes.push_back({{"scene", name},
                        {"description", simulation.description()},
                        {"scans", simulation.size()}});
    } else {
      print(fmt::format("{:<12} {}\n{:<12} {}\n", name, simulation.description(), "",
                        counted(simulation.size(), "scan")));
    }
  }
  if (json) print_json(scenes);
}

std::vector<Vector3f> surface_points(const Scene& scene, double spacing) {
  std::vector<Vector3f> points;
  for (const SurfaceSample& sample : scene.sample_surface(spacing)) {
    points.push_back(sample.point.cast<float>());
  }
  return points;
}

[[noreturn]] void fail(const char* doing, const std::filesystem::path& path, int code) {
  throw Error(ErrorKind::io, fmt::format("cannot {} {}: {}", doing, path.string(),
                                         std::generic_category().message(code)));
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) fail("write", file, errno);
}

struct Written {
  std::uint64_t points = 0;
  std::uint64_t surface_points = 0;
};

// Returns the number of points.
std::uint64_t write_scans(const Simulation& simulation, ScanEnding ending,
                          const std::filesystem::path& folder, const SignalHold& hold) {
  ScanFolderWriter writer(folder, fmt::format(".{}", word_of(ending)));
  Progress progress("simulating", simulation.size());
  std::uint64_t points = 0;
  for (std::size_t i = 0; i < simulation.size(); ++i) {
    hold.check();
    const Scan scan = simulation.scan(i);
    if (scan.points.empty() && ending == ScanEnding::bin) {
      throw Error(ErrorKind::input,
                  fmt::format("scan {} of {} holds no point, which a .bin file cannot say: take "
                              "--format pcd",
                              i, simulation.name()));
    }
    points += scan.points.size();
    writer.add(scan);
    progress.advance();
  }
  writer.finish();
  return points;
}

// Returns the number of points on the surface.
std::uint64_t write_truth(const Simulation& simulation, double spacing,
                          const std::filesystem::path& folder) {
  const std::vector<Vector3f> surface = surface_points(simulation.scene(), spacing);
  const std::filesystem::path file = folder / kSurfaceFile;
  std::error_code code;
  std::filesystem::create_directory(file.parent_path(), code);
  if (code) fail("create the folder", file.parent_path(), code.value());
  write_points(file, surface);
  Json truth = truth_of(simulation);
  truth["surface"] = {{"file", kSurfaceFile}, {"spacing", spacing}, {"points", surface.size()}};
  write_text(folder / kTruthFile, text_of(truth));
  return surface.size();
}

Written write_all(const Simulation& simulation, const SimulateArguments& arguments) {
  const SignalHold hold;
  StagedFolder folder(arguments.output);
  check_no_scans(arguments.output);
  Written written;
  folder.fill([&](const std::filesystem::path& staging) {
    written.points = write_scans(simulation, arguments.ending, staging, hold);
    written.surface_points = write_truth(simulation, arguments.spacing, staging);
  });
  hold.check();
  folder.publish("poses.txt");
  return written;
}

void run(const SimulateArguments& arguments) {
  if (arguments.list) return list_scenes(arguments.json);
  if (arguments.scene.empty() || arguments.output.empty()) {
    throw UsageError(
        fmt::format("{} is missing: `rmap simulate SCENE -o FOLDER` (see rmap simulate "
                    "--help)",
                    arguments.scene.empty() ? "SCENE" : "-o"));
  }
  SimulationOptions options{.scans = arguments.scans,
                            .noise = arguments.noise,
                            .dropped = arguments.dropped,
                            .no_returns = false,  // the files have no place for them
                            .seed = arguments.seed};
  if (!arguments.sensor.empty()) options.sensor = make_sensor(arguments.sensor);
  const Simulation simulation = make_simulation(arguments.scene, options);
  const Written written = write_all(simulation, arguments);
  if (arguments.json) {
    print_json({{"scene", simulation.name()},
                {"output", arguments.output.string()},
                {"scans", simulation.size()},
                {"points", written.points},
                {"surface_points", written.surface_points},
                {"seed", arguments.seed}});
  } else {
    print(fmt::format("{}: {} of {} with {}\n  truth       {} and {} with {}\n",
                      arguments.output.string(), counted(simulation.size(), "scan"),
                      simulation.name(), counted(written.points, "point"), kTruthFile, kSurfaceFile,
                      counted(written.surface_points, "point")));
  }
}

}  // namespace

void add_simulate(CLI::App& app) {
  CLI::App& verb =
      *app.add_subcommand("simulate", "Make scans with poses of a scene whose truth is known.");
  const auto arguments = std::make_shared<SimulateArguments>();
  set_help(
      verb,
      {.usage = "SCENE -o FOLDER [options]",
       .text =
           {"Scenes: " + joined(scene_names()) + ". --list describes them.",
            "The folder gets scans in the sensor's frame, poses.txt, truth.json (all objects of "
            "the scene exactly, the sensor and the times of the scans) and truth/surface.pcd "
            "(points of the true static surface in the map's frame). `rmap compare MAP "
            "FOLDER/truth/surface.pcd` measures a map by it. The same options give the same "
            "bytes."},
       .examples = {"rmap simulate street --scans 3 -o street",
                    "rmap simulate room --sensor depth_camera --noise 0.01 --seed 7 -o noisy",
                    "rmap simulate --list"}});
  verb.add_option("SCENE", arguments->scene, "Name of the scene.");
  add_path(verb, "-o,--output", arguments->output,
           "Folder for the scans, without scans or poses so far; made where it is missing.",
           "FOLDER");
  add_integer(verb, "--scans", arguments->scans,
              "Number of scans, spread over the scene's way (default: the scene's own).", 1);
  verb.add_option("--sensor", arguments->sensor,
                  "Sensor: " + joined(sensor_names()) + " (default: the scene's own).")
      ->type_name("NAME")
      ->option_text("NAME");
  add_number(verb, "--noise", arguments->noise,
             "Standard deviation of the error along the beam, metres (default: the scene's own).");
  add_number(verb, "--dropped", arguments->dropped,
             "Share of the returns that get lost, 0 to 1 (default 0).");
  add_seed(verb, "--seed", arguments->seed, "Seed of all chance (default 0).");
  add_word(verb, "--format", arguments->ending,
           fmt::format("Files of the scans: {} (default bin).", word_list<ScanEnding>()));
  add_number(verb, "--spacing", arguments->spacing,
             fmt::format("Distance of the points in truth/surface.pcd, metres (default {}).",
                         kSurfaceSpacing));
  verb.add_flag("--list", arguments->list, "Describe the scenes and do nothing else.");
  add_json_flag(verb, arguments->json);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
