#include "approximation/cover_registry.hpp"

#include <algorithm>

namespace rmap {

namespace {

using Word = BitRows::Word;

BitRows copy_of(const BitRows& rows) {
  BitRows copy(rows.size(), rows.axis());
  const Word* const words = rows.row(Cell::Zero());
  const std::ptrdiff_t count = rows.words_in_row() * rows.size().y() * rows.size().z();
  std::copy(words, words + count, copy.row(Cell::Zero()));
  return copy;
}

}  // namespace

CoverRegistry::CoverRegistry(const BitRows& required)
    : required_(copy_of(required)), numbers_(required_), covers_(numbers_.size()) {}

template <class Use>
void CoverRegistry::for_each_range(const CellBox& covered, const Use& use) const {
  const Run run{covered.min.x(), covered.max.x() - 1};
  for (std::int32_t z = covered.min.z(); z < covered.max.z(); ++z) {
    for (std::int32_t y = covered.min.y(); y < covered.max.y(); ++y) {
      numbers_.for_each_range(
          required_, {0, y, z}, run,
          [&](std::uint32_t first, std::uint32_t count, std::ptrdiff_t word, Word cells) {
            use(first, count, cells, Cell(static_cast<std::int32_t>(word * 64), y, z));
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
