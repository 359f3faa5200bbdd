#pragma once

#include <string_view>

namespace rmap {

/// Order of names as people count: runs of digits compare as numbers of any length, so
/// 2 comes before 10; all else byte by byte. Total: only equal names are equivalent.
bool natural_less(std::string_view a, std::string_view b);

}  // namespace rmap
