#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <rmap/block.hpp>

namespace rmap {

/// The cells of a block as they lie in memory, in units of a value: a byte that tells
/// which of the mask's eight words have a bit, these words, then a value for each bit.
/// Few cells take few bytes; a full block takes a 500th more than with the mask as it is.
namespace packed_block {

inline constexpr std::size_t kHeader = 1;
inline constexpr std::size_t kWord = sizeof(std::uint64_t) / sizeof(Value);
inline constexpr std::size_t kMaxLength = kHeader + 8 * kWord + kBlockCells;

inline std::uint32_t words_present(const CellMask& cells) {
  std::uint32_t present = 0;
  for (std::uint32_t i = 0; i < cells.words().size(); ++i) {
    present |= (cells.words()[i] != 0 ? 1U : 0U) << i;
  }
  return present;
}

/// Units that a block with these cells takes.
inline std::uint32_t length(const CellMask& cells) {
  return static_cast<std::uint32_t>(kHeader + kWord * bit_count(words_present(cells)) +
                                    cells.count());
}

namespace detail {

inline std::uint32_t present(const Value* run) { return static_cast<std::uint8_t>(*run); }
inline std::uint64_t word(const Value* run, std::uint32_t place) {
  std::uint64_t word = 0;
  std::memcpy(&word, run + kHeader + kWord * place, sizeof(word));
  return word;
}

}  // namespace detail

/// The cells of a block that was written by write_cells.
inline CellMask cells(const Value* run) {
  CellMask mask;
  std::uint32_t place = 0;
  for (std::uint32_t left = detail::present(run); left != 0; left &= left - 1) {
    mask.words()[static_cast<std::size_t>(std::countr_zero(left))] = detail::word(run, place++);
  }
  return mask;
}

/// Those of them that lie in a box.
inline CellMask cells(const Value* run, const CellsBetween& box) {
  CellMask mask;
  std::uint32_t place = 0;
  for (std::uint32_t left = detail::present(run); left != 0; left &= left - 1, ++place) {
    const auto i = static_cast<std::size_t>(std::countr_zero(left));
    if (const std::uint64_t wanted = box.word(i)) {
      mask.words()[i] = detail::word(run, place) & wanted;
    }
  }
  return mask;
}

inline const Value* values(const Value* run) {
  return run + kHeader + kWord * bit_count(detail::present(run));
}
inline Value* values(Value* run) { return run + kHeader + kWord * bit_count(detail::present(run)); }

/// The value of one cell, null where it does not exist.
inline const Value* find(const Value* run, BlockPosition position) {
  const std::uint32_t present = detail::present(run);
  const std::uint32_t word_bit = 1U << (position / 64);
  if ((present & word_bit) == 0) return nullptr;
  const std::uint32_t place = bit_count(present & (word_bit - 1));
  const std::uint64_t word = detail::word(run, place);
  const std::uint64_t bit = std::uint64_t{1} << (position % 64);
  if ((word & bit) == 0) return nullptr;
  std::uint32_t rank = bit_count(word & (bit - 1));
  for (std::uint32_t i = 0; i < place; ++i) rank += bit_count(detail::word(run, i));
  return values(run) + rank;
}

/// use(position, value) for each cell, positions ascending.
template <class Use>
void for_each(const Value* run, Use&& use) {
  const std::uint32_t present = detail::present(run);
  const Value* value = run + kHeader + kWord * bit_count(present);
  std::uint32_t place = 0;
  for (std::uint32_t words = present; words != 0; words &= words - 1) {
    const auto first = static_cast<BlockPosition>(64 * std::countr_zero(words));
    for (std::uint64_t left = detail::word(run, place++); left != 0; left &= left - 1) {
      use(first + static_cast<BlockPosition>(std::countr_zero(left)), *value++);
    }
  }
}

/// Writes which cells there are; their values are to be written behind it.
inline void write_cells(Value* run, const CellMask& cells) {
  const std::uint32_t present = words_present(cells);
  *run = static_cast<Value>(present);
  Value* next = run + kHeader;
  for (std::uint32_t left = present; left != 0; left &= left - 1, next += kWord) {
    const std::uint64_t& word = cells.words()[static_cast<std::size_t>(std::countr_zero(left))];
    std::memcpy(next, &word, sizeof(word));
  }
}

}  // namespace packed_block
}  // namespace rmap
