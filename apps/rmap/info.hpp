#pragma once

#include "json.hpp"

#include <filesystem>
#include <string>

#include <rmap/map_file.hpp>
#include <rmap/scan_read_options.hpp>

namespace rmap::command {

// What is in a file or folder, for programs and in words. They read all of it and throw
// Error as the library's readers.

struct Description {
  Json json;
  std::string words;
};

Description describe_map(const std::filesystem::path& file, const LoadOptions& options);
Description describe_octomap(const std::filesystem::path& file);
Description describe_bag(const std::filesystem::path& path);
Description describe_scans(const std::filesystem::path& folder, const ScanReadOptions& options);
Description describe_cloud(const std::filesystem::path& file, const ScanReadOptions& options);
Description describe_cuboids(const std::filesystem::path& file);

}  // namespace rmap::command
