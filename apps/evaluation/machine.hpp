#pragma once

#include "evaluation/json.hpp"

namespace rmap::evaluation {

/// What the figures were taken on: processor, cores, compiler, versions, the day.
Json describe_machine();

}  // namespace rmap::evaluation
