#pragma once

#include "evaluation/json.hpp"

#include <string>
#include <vector>

namespace rmap::evaluation {

/// Flat objects with the same keys as comma-separated values, a header first. What is null is left
/// empty; texts with commas are quoted.
std::string csv_of(const std::vector<Json>& rows);

}  // namespace rmap::evaluation
