#include "approximation/star.hpp"

#include <algorithm>
#include <bit>

namespace rmap {

Stars::Stars(const BitGrid& allowed, const BitRows& cells)
    : allowed_(allowed), cells_(cells), numbers_(cells) {
  places_.reserve(numbers_.size());
  for (std::int32_t z = 0; z < cells.size().z(); ++z) {
    for (std::int32_t y = 0; y < cells.size().y(); ++y) {
      const BitRows::Word* const row = cells.row({0, y, z});
      for (std::ptrdiff_t word = 0; word < cells.words_in_row(); ++word) {
        for (BitRows::Word left = row[word]; left != 0; left &= left - 1) {
          const auto x = static_cast<std::int32_t>(word * 64 + std::countr_zero(left));
          places_.emplace_back(x, y, z);
        }
      }
    }
  }
}

namespace {

/// Narrows a run to what the row leaves around `x`; false when that is nothing.
bool narrow(const BitRows::Word* row, std::int32_t x, Run& run) {
  if (((row[BitRows::word_of(x)] >> BitRows::bit_of(x)) & 1) == 0) return false;
  run = intersection(run, run_around(row, x));
  return true;
}

}  // namespace

void Stars::begin(const Cell& cell, Layer& layer) const {
  const BitRows& rows = allowed_.rows(0);
  const BitRows::Word* const middle = rows.row({0, cell.y(), cell.z()});
  layer.column = run_around(middle, cell.x());
  const auto fill = [&](std::vector<Run>& runs, std::ptrdiff_t stride) {
    runs.clear();
    const BitRows::Word* row = middle + stride;
    for (Run run = layer.column; narrow(row, cell.x(), run); row += stride) runs.push_back(run);
  };
  fill(layer.up, rows.stride(1));
  fill(layer.down, -rows.stride(1));
}

bool Stars::step(const Cell& cell, std::int32_t z, Layer& layer) const {
  const BitRows& rows = allowed_.rows(0);
  const BitRows::Word* const middle = rows.row({0, cell.y(), z});
  if (!narrow(middle, cell.x(), layer.column)) return false;
  const auto narrow_beyond = [&](std::vector<Run>& runs, std::ptrdiff_t stride) {
    const BitRows::Word* row = middle + stride;
    Run before = layer.column;
    std::size_t i = 0;
    for (; i < runs.size(); ++i, row += stride) {
      before = intersection(before, runs[i]);
      if (!narrow(row, cell.x(), before)) break;
      runs[i] = before;
    }
    runs.resize(i);
  };
  narrow_beyond(layer.up, rows.stride(1));
  narrow_beyond(layer.down, -rows.stride(1));
  return true;
}

}  // namespace rmap
