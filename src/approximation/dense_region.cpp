#include "approximation/dense_region.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace rmap {

namespace {

using Word = BitRows::Word;

int room_around(const CoverLimits& limits) { return 1 + limits.outer + limits.inner; }

/// Grows the set by one cell along x.
void dilate_along_x(BitRows& rows) {
  const std::ptrdiff_t words = rows.words_in_row();
  Word* row = rows.row(Cell::Zero());
  const Word* const end = row + words * rows.size().y() * rows.size().z();
  for (; row != end; row += words) {
    Word before = 0;
    for (std::ptrdiff_t i = 0; i < words; ++i) {
      const Word here = row[i];
      const Word behind = i + 1 < words ? row[i + 1] : 0;
      row[i] = here | here << 1 | here >> 1 | before >> 63 | behind << 63;
      before = here;
    }
  }
}

/// Grows the set by one cell along another axis, on which rows lie `stride` words apart.
void dilate_across(BitRows& rows, int axis) {
  const std::ptrdiff_t stride = rows.stride(axis);
  const std::ptrdiff_t words = rows.words_in_row();
  const int other = 3 - axis;  // of 1 and 2
  std::vector<Word> before(static_cast<std::size_t>(words));
  for (std::int32_t o = 0; o < rows.size()[other]; ++o) {
    Word* row = rows.row(Cell::Zero()) + o * rows.stride(other);
    std::fill(before.begin(), before.end(), 0);
    for (std::int32_t at = 0; at < rows.size()[axis]; ++at, row += stride) {
      const bool last = at + 1 == rows.size()[axis];
      for (std::ptrdiff_t i = 0; i < words; ++i) {
        const Word here = row[i];
        row[i] |= before[static_cast<std::size_t>(i)] | (last ? 0 : row[i + stride]);
        before[static_cast<std::size_t>(i)] = here;
      }
    }
  }
}

/// Copies the set of the rows along x to those along y and z.
void spread(BitGrid& grid) {
  const BitRows& rows = grid.rows(0);
  for (std::int32_t z = 0; z < rows.size().z(); ++z) {
    for (std::int32_t y = 0; y < rows.size().y(); ++y) {
      const Word* const row = rows.row({0, y, z});
      for (std::ptrdiff_t i = 0; i < rows.words_in_row(); ++i) {
        for (Word left = row[i]; left != 0; left &= left - 1) {
          const auto x = static_cast<std::int32_t>(i * 64 + std::countr_zero(left));
          grid.rows(1).set({x, y, z});
          grid.rows(2).set({x, y, z});
        }
      }
    }
  }
}

}  // namespace

DenseRegion::DenseRegion(std::span<const Cell> cells, const CellBox& region,
                         const CoverLimits& limits)
    : origin_((region.min.array() - room_around(limits)).matrix()),
      allowed_((region.max - region.min).array() + 2 * room_around(limits)) {
  BitRows& rows = allowed_.rows(0);
  for (const Cell& cell : cells) rows.set(to_local(cell));
  for (int i = 0; i < limits.outer; ++i) {
    dilate_along_x(rows);
    dilate_across(rows, 1);
    dilate_across(rows, 2);
  }
  spread(allowed_);
  forbid_beyond_limits();
}

void DenseRegion::forbid_beyond_limits() {
  const CellBox all{.min = Cell::Zero(), .max = allowed_.size()};
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t first = std::int64_t{kMinCellIndex} - origin_[axis];
    const std::int64_t end = std::int64_t{kMaxCellIndex} + 1 - origin_[axis];
    CellBox beyond = all;
    if (first > 0) {
      beyond.max[axis] = static_cast<std::int32_t>(first);
      allowed_.reset(beyond);
    }
    if (end < all.max[axis]) {
      beyond = all;
      beyond.min[axis] = static_cast<std::int32_t>(end);
      allowed_.reset(beyond);
    }
  }
}

}  // namespace rmap
