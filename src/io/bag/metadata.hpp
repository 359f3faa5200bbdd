#pragma once

#include <filesystem>
#include <vector>

namespace rmap {

/// The file that makes a folder a bag of rosbag2.
inline constexpr const char* kMetadataName = "metadata.yaml";

/// The files with the messages of such a folder, in their order. Only their names count, as old
/// releases put folders before them; nothing outside of the folder is named. Throws Error(input)
/// when the file does not say, or names files that are compressed as a whole.
std::vector<std::filesystem::path> read_bag_files(const std::filesystem::path& folder);

}  // namespace rmap
