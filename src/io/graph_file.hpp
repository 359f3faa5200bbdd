#pragma once

#include <filesystem>
#include <memory>

#include <rmap/scan_source.hpp>

namespace rmap {

/// Opens a scan graph of OctoMap (`.graph`, binary): nodes of a cloud in the sensor's frame, a
/// pose and a number each. The edges between them say nothing of where points are and are
/// passed over. Scans are read one at a time.
std::unique_ptr<ScanSource> open_scan_graph(const std::filesystem::path& file,
                                            const ScanReadOptions& options);

}  // namespace rmap
