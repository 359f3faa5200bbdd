#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rmap::test {

/// The folder with real scans: the environment variable RMAP_DATA, or the place
/// that was named when the tests were configured. Empty when it is not there.
std::filesystem::path data_folder();

/// The sequences that the tests use, by name of their folder.
const std::vector<std::string>& sequence_names();

/// The folder of a sequence; empty when it is missing, and the test should skip.
std::filesystem::path sequence_folder(const std::string& name);

}  // namespace rmap::test
