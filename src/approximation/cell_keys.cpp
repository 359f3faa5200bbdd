#include "approximation/cell_keys.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace rmap {

namespace {

constexpr int kDigitBits = 11;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;

// By one digit, the lowest first: the order of those before it stays among equal ones.
void sort_by_digit(std::span<const std::uint64_t> keys, int shift,
                   std::span<std::uint64_t> sorted) {
  const auto digit = [&](std::uint64_t key) { return key >> shift & (kDigits - 1); };
  std::array<std::size_t, kDigits> next = {};
  for (const std::uint64_t key : keys) ++next[digit(key)];
  std::size_t first = 0;
  for (std::size_t& place : next) first += std::exchange(place, first);
  for (const std::uint64_t key : keys) sorted[next[digit(key)]++] = key;
}

}  // namespace

std::optional<CellKeys> CellKeys::of(const CellBox& box) {
  const auto bits = [&](int axis) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(box.extent()[axis] - 1)));
  };
  CellKeys keys;
  keys.min_ = box.min;
  keys.shift_y_ = bits(0);
  keys.shift_z_ = keys.shift_y_ + bits(1);
  keys.bits_ = keys.shift_z_ + bits(2);
  if (keys.bits_ >= 64) return std::nullopt;
  return keys;
}

void sort_keys(std::vector<std::uint64_t>& keys, int bits, std::vector<std::uint64_t>& spare) {
  if (std::is_sorted(keys.begin(), keys.end())) return;
  // Few numbers are sorted before the digits of one would be counted.
  if (keys.size() < kDigits) {
    std::sort(keys.begin(), keys.end());
    return;
  }
  spare.resize(keys.size());
  for (int shift = 0; shift < bits; shift += kDigitBits) {
    sort_by_digit(keys, shift, spare);
    keys.swap(spare);
  }
}

}  // namespace rmap
