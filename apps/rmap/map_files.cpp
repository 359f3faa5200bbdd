#include "map_files.hpp"

#include "signals.hpp"
#include "words.hpp"

#include <cerrno>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include <rmap/cells.hpp>
#include <rmap/error.hpp>
#include <rmap/map_file.hpp>

namespace rmap::command {

namespace {

bool is_device_or_pipe(const std::filesystem::path& file) {
  std::error_code missing;
  return std::filesystem::is_other(std::filesystem::status(file, missing));
}

}  // namespace

void check_map_output(const std::filesystem::path& file) {
  if (is_device_or_pipe(file)) return;
  if (ending_of(file) != ".rmap") {
    throw Error(ErrorKind::input,
                fmt::format("the output {} does not end in .rmap, as a map must: `rmap convert` "
                            "makes other formats of a map",
                            file.string()));
  }
  check_output_folder(file);
}

void check_output_folder(const std::filesystem::path& file) {
  if (is_device_or_pipe(file)) return;
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (::access(folder.c_str(), W_OK | X_OK) != 0) {
    throw Error(ErrorKind::io,
                fmt::format("cannot write {} into the folder {}: {}", file.string(),
                            folder.string(), std::generic_category().message(errno)));
  }
}

void save_map(const Grid& grid, const std::filesystem::path& file) {
  const SignalHold hold;
  save(grid, file);
  hold.check();
}

std::size_t occupied_cells(const Grid& grid) { return count_cells(grid, {.occupied_only = true}); }

}  // namespace rmap::command
