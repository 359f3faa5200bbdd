#pragma once

#include <memory>

#include <rmap/scan_source.hpp>

namespace rmap {

/// The scans of `source` with the points at distance `range` from the sensor (metres, to 1e-6
/// of it) as directions without return.
std::unique_ptr<ScanSource> with_no_returns(std::unique_ptr<ScanSource> source, double range);

}  // namespace rmap
