#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace rmap {

/// Nanoseconds of a time in seconds given as decimal text, as 1690309709.284305600 or
/// 1.5e+02. A double would keep such a time to 240 ns only; here it is exact, and rounded
/// half away from zero beyond nine decimals. Nothing when the word is no decimal number, or
/// beyond 64 bits.
std::optional<std::int64_t> parse_time(std::string_view word);

/// The time in seconds with all nine decimals, for messages.
std::string time_text(std::int64_t nanoseconds);

}  // namespace rmap
