#pragma once

#include "io/scan_file_source.hpp"

#include <filesystem>
#include <memory>

#include <rmap/scan_source.hpp>

namespace rmap {

/// Opens one file of points as a scan. Where its beams began is, in this order, what the
/// options say, what stands beside it in its folder, and what it says itself.
std::unique_ptr<ScanSource> open_scan_file(const std::filesystem::path& file,
                                           const ScanReadOptions& options);

/// What a file of points says itself, which is read for it: origins of its points, or a pose.
/// Without either it has no pose.
ScanFile describe_scan_file(const std::filesystem::path& file, const ScanReadOptions& options);

}  // namespace rmap
