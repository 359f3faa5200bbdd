#include "map_files.hpp"

#include "octomap_maps.hpp"
#include "signals.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include <rmap/cells.hpp>
#include <rmap/error.hpp>
#include <rmap/map_file.hpp>
#include <rmap/scan_files.hpp>

namespace rmap::command {

namespace {

namespace fs = std::filesystem;

fs::file_status status_of(const fs::path& file) {
  std::error_code missing;
  return fs::status(file, missing);
}

[[noreturn]] void refuse(const fs::path& file, const std::string& why) {
  throw Error(ErrorKind::io, fmt::format("cannot write {}: {}", file.string(), why));
}

}  // namespace

void check_output_file(const fs::path& file) {
  const fs::file_status status = status_of(file);
  if (fs::is_other(status)) return;
  if (file.empty()) throw Error(ErrorKind::input, "the output has no name: it must be a file");
  if (fs::is_directory(status)) refuse(file, "it is a folder, and must be a file");
  if (fs::exists(status) && ::access(file.c_str(), W_OK) != 0) {
    refuse(file, std::generic_category().message(errno));
  }
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    refuse(file, fmt::format("its folder {}: {}", folder.string(),
                             std::generic_category().message(errno)));
  }
}

void check_map_output(const fs::path& file) {
  if (!fs::is_other(status_of(file)) && ending_of(file) != ".rmap") {
    throw Error(ErrorKind::input,
                fmt::format("the output {} does not end in .rmap, as a map must: `rmap convert` "
                            "makes other formats of a map",
                            file.string()));
  }
  check_output_file(file);
}

void check_cuboid_output(const fs::path& file) {
  constexpr std::array kEndings{".rcs",  ".csv", ".json", ".ply",  ".glb",
                                ".urdf", ".sdf", ".xml",  ".scene"};
  const std::string ending = ending_of(file);
  if (std::find(kEndings.begin(), kEndings.end(), ending) == kEndings.end()) {
    throw Error(ErrorKind::input,
                fmt::format("the output {} must end in .rcs, .csv, .json, .ply, .glb, .urdf, .sdf, "
                            ".xml (MuJoCo) or .scene (MoveIt)",
                            file.string()));
  }
  check_output_file(file);
}

Grid load_map(const fs::path& file, const LoadOptions& options) {
  if (is_octomap(file)) {
    throw Error(ErrorKind::input,
                fmt::format("{} is a map of OctoMap as far as its name says: `rmap convert {} "
                            "MAP.rmap` makes one of it that can be used here",
                            file.string(), file.string()));
  }
  return load(file, options);
}

void save_map(const Grid& grid, const fs::path& file) {
  const SignalHold hold;
  save(grid, file);
  hold.check();
}

std::size_t occupied_count(const Grid& grid) { return count_cells(grid, {.occupied_only = true}); }

}  // namespace rmap::command
