#include "info.hpp"

#include "arguments.hpp"
#include "help.hpp"
#include "map_options.hpp"
#include "output.hpp"
#include "scan_options.hpp"
#include "verbs.hpp"

#include <memory>
#include <vector>

#include <fmt/format.h>

#include <rmap/bag_info.hpp>
#include <rmap/error.hpp>
#include <rmap/scan_files.hpp>

namespace rmap::command {

namespace {

struct InfoArguments {
  std::vector<std::filesystem::path> files;
  LoadOptions load;
  ScanOptions reading;
  bool json = false;
};

Description describe(const std::filesystem::path& file, const LoadOptions& options,
                     const ScanReadOptions& reading) {
  if (is_bag(file)) return describe_bag(file);
  std::error_code missing;
  if (std::filesystem::is_directory(file, missing)) return describe_scans(file, reading);
  const std::string ending = ending_of(file);
  if (ending == ".graph") return describe_scans(file, reading);
  if (is_point_file(file)) return describe_cloud(file, reading);
  if (ending == ".rcs") return describe_cuboids(file);
  if (ending == ".bt" || ending == ".ot") return describe_octomap(file);
  // Whatever else it is called: the reader says what is wrong with a file that is none.
  return describe_map(file, options);
}

void run(const InfoArguments& arguments) {
  Json answers = Json::array();
  for (const std::filesystem::path& file : arguments.files) {
    Description description = describe(file, arguments.load, arguments.reading.options());
    if (arguments.json) {
      answers.push_back(std::move(description.json));
    } else {
      print(description.words);
    }
  }
  if (arguments.json) print_json(answers.size() == 1 ? answers.front() : answers);
}

}  // namespace

void add_info(CLI::App& app) {
  CLI::App& verb = *app.add_subcommand("info", "Tell what is in maps, scans and clouds.");
  const auto arguments = std::make_shared<InfoArguments>();
  set_help(
      verb,
      {.usage = "FILE... [options]",
       .text =
           {"A .rmap file is a map, .bt and .ot are maps of OctoMap, a folder or a .graph holds "
            "scans with poses, .pcd, .ply, .las, .bin, .xyz, .csv and .3d are clouds of points, a "
            ".rcs file holds cuboids; a bag (.mcap, .db3, a folder of rosbag2) holds topics, and "
            "the answer says how to build from it. All of it is read and checked. With --json one "
            "file gives an object, several an array of them; what is infinite or does not exist "
            "is null.",
            "A map file does not say how the map lay in memory: the options choose how it "
            "is loaded, which decides the figures of the R-tree and of the memory."},
       .examples = {"rmap info street.rmap",
                    "rmap info street.rmap --layout cells "
                    "--max-branches 8 --json",
                    "rmap info street street/truth/surface.pcd"}});
  add_paths(verb, "FILE", arguments->files, "Maps, folders of scans, bags, clouds, cuboids.")
      ->required();
  add_json_flag(verb, arguments->json);
  arguments->reading.add_to(verb);
  add_load_options(verb, arguments->load);
  verb.callback([arguments] { run(*arguments); });
}

}  // namespace rmap::command
