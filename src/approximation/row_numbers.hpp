#pragma once

#include "approximation/bit_rows.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rmap/block.hpp>

namespace rmap {

/// Numbers the cells of a set in rows along x: along the rows, which follow one another by y, then
/// z. Cells of one word then have numbers in a row.
class RowNumbers {
 public:
  /// Of the set as it is; the rows that are asked for later must be those.
  explicit RowNumbers(const BitRows& cells) {
    const BitRows::Word* const words = cells.row(Cell::Zero());
    const std::ptrdiff_t count = cells.words_in_row() * cells.size().y() * cells.size().z();
    first_.reserve(static_cast<std::size_t>(count));
    for (std::ptrdiff_t word = 0; word < count; ++word) {
      first_.push_back(size_);
      size_ += bit_count(words[word]);
    }
  }

  /// Number of cells.
  std::uint32_t size() const { return size_; }

  /// use(first, count, word, inside) for each word of the row through `at` with cells in the run:
  /// these have the numbers from `first` on, and are the bits `inside` of that word.
  template <class Use>
  void for_each_range(const BitRows& cells, const Cell& at, const Run& run, const Use& use) const {
    const BitRows::Word* const row = cells.row(at);
    const std::uint32_t* const numbers = first_.data() + (row - cells.row(Cell::Zero()));
    BitRows::for_each_word(run, [&](std::ptrdiff_t word, BitRows::Word mask) {
      const BitRows::Word inside = row[word] & mask;
      if (inside == 0) return;
      const BitRows::Word lowest = inside & (~inside + 1);
      use(numbers[word] + bit_count(row[word] & (lowest - 1)), bit_count(inside), word, inside);
    });
  }

 private:
  std::vector<std::uint32_t> first_;  // by word: number of its first cell
  std::uint32_t size_ = 0;
};

}  // namespace rmap
