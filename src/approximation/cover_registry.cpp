#include "approximation/cover_registry.hpp"

#include <algorithm>

namespace rmap {

namespace {

using Word = BitRows::Word;

std::ptrdiff_t words_of(const BitRows& rows) {
  return rows.words_in_row() * rows.size().y() * rows.size().z();
}

BitRows copy_of(const BitRows& rows) {
  BitRows copy(rows.size(), rows.axis());
  const Word* const words = rows.row(Cell::Zero());
  std::copy(words, words + words_of(rows), copy.row(Cell::Zero()));
  return copy;
}

}  // namespace

CoverRegistry::CoverRegistry(const BitRows& required) : required_(copy_of(required)) {
  const Word* const words = required_.row(Cell::Zero());
  rank_.reserve(static_cast<std::size_t>(words_of(required_)));
  std::uint32_t rank = 0;
  for (std::ptrdiff_t word = 0; word < words_of(required_); ++word) {
    rank_.push_back(rank);
    rank += bit_count(words[word]);
  }
  covers_.resize(rank);
}

template <class Use>
void CoverRegistry::for_each_range(const CellBox& covered, const Use& use) const {
  const Word* const words = required_.row(Cell::Zero());
  const Run run{covered.min.x(), covered.max.x() - 1};
  Cell at = covered.min;
  for (at.z() = covered.min.z(); at.z() < covered.max.z(); ++at.z()) {
    for (at.y() = covered.min.y(); at.y() < covered.max.y(); ++at.y()) {
      const Word* const row = required_.row({0, at.y(), at.z()});
      BitRows::for_each_word(run, [&](std::ptrdiff_t word, Word mask) {
        const Word cells = row[word] & mask;
        if (cells == 0) return;
        const Word lowest = mask & (~mask + 1);
        const Word before = row[word] & (lowest - 1);
        const std::uint32_t first =
            rank_[static_cast<std::size_t>(row - words + word)] + bit_count(before);
        use(first, bit_count(cells), cells,
            Cell(static_cast<std::int32_t>(word * 64), at.y(), at.z()));
      });
    }
  }
}

void CoverRegistry::add(std::uint32_t box, const CellBox& covered) {
  std::uint32_t own = 0;
  for_each_range(covered, [&](std::uint32_t first, std::uint32_t count, Word, const Cell&) {
    for (std::uint32_t cell = first; cell < first + count; ++cell) {
      Cover& cover = covers_[cell];
      if (cover.count == 0) ++own;
      if (cover.count == 1) --sole_[cover.boxes];
      ++cover.count;
      cover.boxes ^= box;
    }
  });
  sole_[box] += own;
}

void CoverRegistry::add(std::uint32_t box, const CellBox& covered,
                        std::vector<std::uint32_t>& idle) {
  std::uint32_t own = 0;
  for_each_range(covered, [&](std::uint32_t first, std::uint32_t count, Word, const Cell&) {
    for (std::uint32_t cell = first; cell < first + count; ++cell) {
      Cover& cover = covers_[cell];
      if (cover.count == 0) ++own;
      if (cover.count == 1 && --sole_[cover.boxes] == 0) idle.push_back(cover.boxes);
      ++cover.count;
      cover.boxes ^= box;
    }
  });
  sole_[box] += own;
}

void CoverRegistry::remove(std::uint32_t box, const CellBox& covered) {
  for_each_range(covered, [&](std::uint32_t first, std::uint32_t count, Word, const Cell&) {
    for (std::uint32_t cell = first; cell < first + count; ++cell) {
      Cover& cover = covers_[cell];
      --cover.count;
      cover.boxes ^= box;
      if (cover.count == 1) ++sole_[cover.boxes];
    }
  });
  sole_[box] = 0;
}

CellBox CoverRegistry::sole_bounds(std::uint32_t box, const CellBox& covered) const {
  CellBox bounds{.min = covered.max, .max = covered.min};
  for_each_range(covered, [&](std::uint32_t first, std::uint32_t, Word cells, const Cell& origin) {
    Word own = 0;
    std::uint32_t cell = first;
    for (Word left = cells; left != 0; left &= left - 1, ++cell) {
      if (covers_[cell].count == 1 && covers_[cell].boxes == box) own |= left & (~left + 1);
    }
    if (own == 0) return;
    const Cell low = origin + Cell(std::countr_zero(own), 0, 0);
    const Cell high = origin + Cell(64 - std::countl_zero(own), 1, 1);
    bounds.min = bounds.min.cwiseMin(low);
    bounds.max = bounds.max.cwiseMax(high);
  });
  return bounds;
}

double CoverRegistry::relief(const CellBox& covered) const {
  double relief = 0;
  for_each_range(covered, [&](std::uint32_t first, std::uint32_t count, Word, const Cell&) {
    for (std::uint32_t cell = first; cell < first + count; ++cell) {
      if (covers_[cell].count == 1) relief += 1.0 / sole_[covers_[cell].boxes];
    }
  });
  return relief;
}

}  // namespace rmap
