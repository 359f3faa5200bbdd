#pragma once

#include <string>
#include <string_view>

#include <rmap/scan_source.hpp>

namespace rmap::fuzz {

/// The whole of a target for a format of scans: the bytes as the file `name`, which a poses.txt of
/// one pose stands beside, opened by `open_scans` and read to the end, twice; both passes must give
/// the same.
void fuzz_scans(std::string_view bytes, const std::string& name,
                const ScanReadOptions& options = {});

}  // namespace rmap::fuzz
