#pragma once

#include <string>
#include <string_view>

namespace rmap::fuzz {

/// Reads the bytes as a file of cuboids with that ending; what was read must come back when it is
/// written and read again.
void fuzz_cuboids(std::string_view bytes, const std::string& ending);

}  // namespace rmap::fuzz
