#pragma once

#include <nlohmann/json.hpp>

namespace rmap::evaluation {

/// Keeps the order of the keys: results read as they are written.
using Json = nlohmann::ordered_json;

}  // namespace rmap::evaluation
