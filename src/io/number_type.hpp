#pragma once

#include "io/bytes.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>

namespace rmap {

/// The types that numbers have in files.
enum class NumberType { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

/// Bytes of a number.
constexpr std::size_t size_of(NumberType type) {
  switch (type) {
    case NumberType::i8:
    case NumberType::u8:
      return 1;
    case NumberType::i16:
    case NumberType::u16:
      return 2;
    case NumberType::i32:
    case NumberType::u32:
    case NumberType::f32:
      return 4;
    default:
      return 8;
  }
}

/// The number whose bytes, in that order, start at `bytes`, of any alignment.
template <class T>
T load_number(const std::byte* bytes, std::endian order) {
  return order == std::endian::little ? load_little<T>(bytes) : load_big<T>(bytes);
}

/// Calls `use(T{})` with the C++ type of a number type.
template <class Use>
void with_type(NumberType type, Use&& use) {
  switch (type) {
    case NumberType::i8:
      return use(std::int8_t{});
    case NumberType::u8:
      return use(std::uint8_t{});
    case NumberType::i16:
      return use(std::int16_t{});
    case NumberType::u16:
      return use(std::uint16_t{});
    case NumberType::i32:
      return use(std::int32_t{});
    case NumberType::u32:
      return use(std::uint32_t{});
    case NumberType::i64:
      return use(std::int64_t{});
    case NumberType::u64:
      return use(std::uint64_t{});
    case NumberType::f32:
      return use(float{});
    case NumberType::f64:
      return use(double{});
  }
}

}  // namespace rmap
