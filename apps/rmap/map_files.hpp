#pragma once

#include <filesystem>

#include <rmap/grid.hpp>

namespace rmap::command {

/// Throws Error(input) unless `file` can be the place of a map: its name ends in .rmap,
/// Called before the long work, not after it.
void check_map_output(const std::filesystem::path& file);

/// Throws Error unless files can be put into the folder of `file`.
void check_output_folder(const std::filesystem::path& file);

/// rmap::save that SIGINT and SIGTERM do not break off; throws Interrupted after it.
void save_map(const Grid& grid, const std::filesystem::path& file);

/// How many cells are occupied.
std::size_t occupied_cells(const Grid& grid);

}  // namespace rmap::command
