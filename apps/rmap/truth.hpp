#pragma once

#include "json.hpp"

#include <cstddef>
#include <string>

#include <rmap/simulation.hpp>

namespace rmap::command {

/// What a simulated scene really is, in numbers that a program can measure a map by:
/// its objects exactly, the sensor with its errors, the times of the scans.
Json truth_of(const Simulation& simulation);

}  // namespace rmap::command
