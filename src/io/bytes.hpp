#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace rmap {

/// The number whose little-endian bytes start at `bytes`, of any alignment.
template <class T>
T load_little(const std::byte* bytes) {
  static_assert(std::is_arithmetic_v<T>);
  std::array<std::byte, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

/// The number whose big-endian bytes start at `bytes`, of any alignment.
template <class T>
T load_big(const std::byte* bytes) {
  static_assert(std::is_arithmetic_v<T>);
  std::array<std::byte, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if constexpr (std::endian::native == std::endian::little) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

/// The bytes of a number, little-endian.
template <class T>
std::array<std::byte, sizeof(T)> little_endian(T value) {
  static_assert(std::is_arithmetic_v<T>);
  auto raw = std::bit_cast<std::array<std::byte, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(raw.begin(), raw.end());
  return raw;
}

}  // namespace rmap
