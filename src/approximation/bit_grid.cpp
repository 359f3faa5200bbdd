#include "approximation/bit_grid.hpp"

#include <rmap/block.hpp>

namespace rmap {

namespace {

/// use(row, run) for each row of a box along the axis of `rows`.
template <class Rows, class Use>
void for_each_row(Rows& rows, const CellBox& box, const Use& use) {
  const int mid = rows.axis() == 0 ? 1 : 0;
  const int out = rows.axis() == 2 ? 1 : 2;
  const Run run{box.min[rows.axis()], box.max[rows.axis()] - 1};
  auto* layer = rows.row(box.min);
  for (std::int32_t o = box.min[out]; o < box.max[out]; ++o, layer += rows.stride(out)) {
    auto* row = layer;
    for (std::int32_t m = box.min[mid]; m < box.max[mid]; ++m, row += rows.stride(mid)) {
      if (!use(row, run)) return;
    }
  }
}

/// The axis on which a box is longest: its rows are fewest there.
int longest(const CellBox& box) {
  int axis = 0;
  (box.max - box.min).maxCoeff(&axis);
  return axis;
}

}  // namespace

void BitGrid::reset(const CellBox& box) {
  for (BitRows& rows : rows_) {
    for_each_row(rows, box, [](BitRows::Word* row, const Run& run) {
      BitRows::for_each_word(run,
                             [&](std::ptrdiff_t word, BitRows::Word mask) { row[word] &= ~mask; });
      return true;
    });
  }
}

std::int64_t BitGrid::count(const CellBox& box) const {
  std::int64_t count = 0;
  for_each_row(rows(longest(box)), box, [&](const BitRows::Word* row, const Run& run) {
    BitRows::for_each_word(run, [&](std::ptrdiff_t word, BitRows::Word mask) {
      count += bit_count(row[word] & mask);
    });
    return true;
  });
  return count;
}

bool BitGrid::holds(const CellBox& box) const {
  bool all = true;
  for_each_row(rows(longest(box)), box,
               [&](const BitRows::Word* row, const Run& run) { return all = row_holds(row, run); });
  return all;
}

}  // namespace rmap
