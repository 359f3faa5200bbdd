#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>

#include <rmap/cell.hpp>

namespace rmap {

/// Cells first to last of a row, both inclusive.
struct Run {
  std::int32_t first = 0;
  std::int32_t last = -1;

  bool contains(const Run& other) const { return first <= other.first && last >= other.last; }
  friend bool operator==(const Run&, const Run&) = default;
};

inline Run intersection(const Run& a, const Run& b) {
  return {a.first > b.first ? a.first : b.first, a.last < b.last ? a.last : b.last};
}

/// A set of cells of a box, a bit each, in rows along one axis. Cells are given from the box's
/// lowest on. The outermost cells on every side must stay out of the set: runs end there.
class BitRows {
 public:
  using Word = std::uint64_t;

  /// All cells of a box of this size are out of the set. Memory that is never touched costs
  /// nothing.
  BitRows(const Cell& size, int axis);

  int axis() const { return axis_; }
  const Cell& size() const { return size_; }

  /// The words of the row through a cell; bit i % 64 of word i / 64 stands for place i.
  const Word* row(const Cell& cell) const { return words_.get() + offset(cell); }
  Word* row(const Cell& cell) { return words_.get() + offset(cell); }
  /// Words from a row to the next one on another axis.
  std::ptrdiff_t stride(int axis) const { return stride_[static_cast<std::size_t>(axis)]; }
  std::ptrdiff_t words_in_row() const { return words_in_row_; }

  bool test(const Cell& cell) const {
    return ((row(cell)[word_of(cell[axis_])] >> bit_of(cell[axis_])) & 1) != 0;
  }
  void set(const Cell& cell) { row(cell)[word_of(cell[axis_])] |= Word{1} << bit_of(cell[axis_]); }
  void reset(const Cell& cell) {
    row(cell)[word_of(cell[axis_])] &= ~(Word{1} << bit_of(cell[axis_]));
  }

  /// use(word, mask) for each word of a row that holds places of the run, with their bits.
  template <class Use>
  static void for_each_word(const Run& run, const Use& use) {
    const std::ptrdiff_t last_word = word_of(run.last);
    Word mask = ~Word{0} << bit_of(run.first);
    for (std::ptrdiff_t word = word_of(run.first); word < last_word; ++word) {
      use(word, mask);
      mask = ~Word{0};
    }
    use(last_word, mask & (~Word{0} >> (63 - bit_of(run.last))));
  }

  static std::ptrdiff_t word_of(std::int32_t place) { return place >> 6; }
  static int bit_of(std::int32_t place) { return place & 63; }

 private:
  std::ptrdiff_t offset(const Cell& cell) const {
    return cell.x() * stride_[0] + cell.y() * stride_[1] + cell.z() * stride_[2];
  }

  struct Free {
    void operator()(Word* words) const;
  };

  Cell size_;
  int axis_;
  std::ptrdiff_t words_in_row_;
  std::array<std::ptrdiff_t, 3> stride_{};
  std::unique_ptr<Word[], Free> words_;
};

/// The places of the longest run in a row that holds `place`, which is set.
inline Run run_around(const BitRows::Word* row, std::int32_t place) {
  using Word = BitRows::Word;
  std::ptrdiff_t word = BitRows::word_of(place);
  Word gaps = ~row[word] & (~Word{0} << BitRows::bit_of(place));
  while (gaps == 0) gaps = ~row[++word];
  const auto last = static_cast<std::int32_t>(word * 64 + std::countr_zero(gaps) - 1);
  word = BitRows::word_of(place);
  gaps = ~row[word] & (~Word{0} >> (63 - BitRows::bit_of(place)));
  while (gaps == 0) gaps = ~row[--word];
  const auto first = static_cast<std::int32_t>(word * 64 + 64 - std::countl_zero(gaps));
  return {first, last};
}

/// Whether all places of the run are set in a row.
inline bool row_holds(const BitRows::Word* row, const Run& run) {
  bool all = true;
  BitRows::for_each_word(
      run, [&](std::ptrdiff_t word, BitRows::Word mask) { all &= (row[word] & mask) == mask; });
  return all;
}

}  // namespace rmap
