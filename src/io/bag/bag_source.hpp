#pragma once

#include <filesystem>
#include <memory>

#include <rmap/scan_source.hpp>

namespace rmap {

/// Opens the clouds of a bag as scans, in the order in which they were recorded. Reads the whole
/// bag once for everything but the points; then one cloud is in memory at a time.
std::unique_ptr<ScanSource> open_bag_scans(const std::filesystem::path& path,
                                           const ScanReadOptions& options);

}  // namespace rmap
