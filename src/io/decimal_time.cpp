#include "io/decimal_time.hpp"

#include <charconv>
#include <limits>

#include <fmt/format.h>

namespace rmap {

namespace {

constexpr int kDecimals = 9;
constexpr int kMostExponent = 100'000;  // beyond it digits cannot be worth anything

bool is_digit(char character) { return character >= '0' && character <= '9'; }

// A number as digits and the place of its point behind the first `point` of them.
struct Decimal {
  bool negative = false;
  std::string digits;
  std::int64_t point = 0;
};

// The exponent that is the whole of `word`.
std::optional<int> parse_exponent(std::string_view word) {
  if (word.starts_with('+')) {
    word.remove_prefix(1);
    if (word.starts_with('-')) return std::nullopt;
  }
  int exponent = 0;
  const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), exponent);
  if (code != std::errc() || end != word.data() + word.size()) return std::nullopt;
  if (exponent > kMostExponent || exponent < -kMostExponent) return std::nullopt;
  return exponent;
}

std::optional<Decimal> parse_decimal(std::string_view word) {
  Decimal decimal;
  if (word.starts_with('-') || word.starts_with('+')) {
    decimal.negative = word.front() == '-';
    word.remove_prefix(1);
  }
  std::size_t used = 0;
  bool behind_point = false;
  for (; used < word.size(); ++used) {
    if (word[used] == '.' && !behind_point) {
      behind_point = true;
    } else if (is_digit(word[used])) {
      decimal.digits += word[used];
      if (!behind_point) ++decimal.point;
    } else {
      break;
    }
  }
  if (decimal.digits.empty()) return std::nullopt;
  if (used == word.size()) return decimal;
  if (word[used] != 'e' && word[used] != 'E') return std::nullopt;
  const auto exponent = parse_exponent(word.substr(used + 1));
  if (!exponent) return std::nullopt;
  decimal.point += *exponent;
  return decimal;
}

// value * 10 + digit; false when it does not fit.
bool append_digit(std::uint64_t& value, unsigned digit) {
  constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (value > (kMost - digit) / 10) return false;
  value = value * 10 + digit;
  return true;
}

}  // namespace

std::optional<std::int64_t> parse_time(std::string_view word) {
  const auto decimal = parse_decimal(word);
  if (!decimal) return std::nullopt;
  const auto digit_at = [&](std::int64_t place) {
    const bool there = place >= 0 && place < static_cast<std::int64_t>(decimal->digits.size());
    return there ? static_cast<unsigned>(decimal->digits[static_cast<std::size_t>(place)] - '0')
                 : 0U;
  };
  // The digits before `end` are whole nanoseconds.
  const std::int64_t end = decimal->point + kDecimals;
  std::uint64_t value = 0;
  for (std::int64_t place = 0; place < end; ++place) {
    if (!append_digit(value, digit_at(place))) return std::nullopt;
  }
  if (digit_at(end) >= 5) ++value;
  if (value > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max())) {
    return std::nullopt;
  }
  const auto time = static_cast<std::int64_t>(value);
  return decimal->negative ? -time : time;
}

std::string time_text(std::int64_t nanoseconds) {
  constexpr std::uint64_t kSecond = 1'000'000'000;
  const bool negative = nanoseconds < 0;
  // Unsigned, since the smallest number has no positive one.
  const auto size = negative ? 0 - static_cast<std::uint64_t>(nanoseconds)
                             : static_cast<std::uint64_t>(nanoseconds);
  return fmt::format("{}{}.{:09}", negative ? "-" : "", size / kSecond, size % kSecond);
}

}  // namespace rmap
