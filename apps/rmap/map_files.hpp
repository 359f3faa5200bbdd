#pragma once

#include <filesystem>

#include <rmap/map_file.hpp>

namespace rmap::command {

// What can be told before the long work is refused there, not after it.

/// Throws Error unless `file` can be written: it is no folder, a former file may be
/// replaced, and its folder takes files. Devices and pipes pass.
void check_output_file(const std::filesystem::path& file);

/// The same for a map, whose name must end in .rmap.
void check_map_output(const std::filesystem::path& file);

/// The same for cuboids, whose name must have one of the endings that they are written to.
void check_cuboid_output(const std::filesystem::path& file);

/// rmap::load, which for a map of OctoMap says how it becomes one that can be loaded.
Grid load_map(const std::filesystem::path& file, const LoadOptions& options = {});

/// rmap::save that SIGHUP, SIGINT and SIGTERM do not break off; throws Interrupted after it.
void save_map(const Grid& grid, const std::filesystem::path& file);

/// How many cells are occupied.
std::size_t occupied_count(const Grid& grid);

}  // namespace rmap::command
