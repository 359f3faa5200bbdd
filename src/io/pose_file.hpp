#pragma once

#include <filesystem>

namespace rmap {

/// Whether the poses of a text file have times: 8 numbers stand in its first line.
bool has_times(const std::filesystem::path& file);

}  // namespace rmap
