#include "grid/inverse/beam_index.hpp"

#include "grid/inverse/binning_kernel.hpp"
#include "grid/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace rmap {

namespace {

constexpr std::uint32_t kNoBin = std::numeric_limits<std::uint32_t>::max();
// Casting reads whole vectors.
constexpr std::size_t kPadding = 64;

// Finer bins mean fewer beams to test for each cell, but more bins to go over.
int bin_bits_for(std::size_t beams) { return beams < 1000 ? 6 : beams < 300'000 ? 7 : 8; }

std::size_t whole_tiles(std::size_t places) {
  return (places / PointTile::kSize + 1) * PointTile::kSize;
}

}  // namespace

BeamIndex::BeamIndex(const Vector3d& origin, std::span<const std::uint32_t> numbers,
                     std::size_t capacity, std::size_t parts)
    : origin_(origin),
      numbers_(numbers),
      bin_bits_(bin_bits_for(capacity)),
      scratch_(4 * Scratch::bytes_for<std::uint32_t>(whole_tiles(capacity)) +
               4 * Scratch::bytes_for<std::uint32_t>(capacity + kPadding) +
               parts * (Scratch::bytes_for<std::int32_t>(border(rows() + 1)) +
                        Scratch::bytes_for<float>(border(rows() + 1)))),
      depth_(1 << bin_bits_) {
  const std::size_t places = whole_tiles(capacity);
  bin_ = scratch_.take<std::uint32_t>(places);
  for (float*& column : inverse_) column = scratch_.take<float>(places);
  sorted_number_ = scratch_.take<std::uint32_t>(capacity + kPadding);
  for (float*& column : sorted_inverse_) column = scratch_.take<float>(capacity + kPadding);
  for (std::size_t i = 0; i < parts; ++i) {
    Part& part = parts_.emplace_back();
    part.row_used.assign(rows(), 0);
    part.count = scratch_.take<std::int32_t>(border(rows() + 1));
    part.depth = scratch_.take<float>(border(rows() + 1));
  }
}

void BeamIndex::clear_row(Part& part, std::size_t row) const {
  std::fill_n(part.count + border(row), bins() + 1, 0);
  std::fill_n(part.depth + border(row), bins() + 1, 0.0F);
}

void BeamIndex::add(const PointTile& tile, std::size_t first, std::size_t part_number) {
  Part& part = parts_[part_number];
  if (part.last == 0) part.first = first;
  part.last = first + tile.count;
  part.has_cut_at_origin |= tile.cut_at_origin;
  BinnedTile binned;
  bin_beams(tile, 1 << bin_bits_, binned,
            {inverse_[0] + first, inverse_[1] + first, inverse_[2] + first});
  std::copy_n(binned.bin.data(), tile.count, bin_ + first);
  tile.beams.missing(tile.count).for_each([&](std::size_t i) { bin_[first + i] = kNoBin; });
  tile.beams.for_each([&](std::size_t i) {
    const std::size_t bin = binned.bin[i];
    const std::size_t row = bin >> bin_bits_;
    if (part.row_used[row] == 0) {
      part.row_used[row] = 1;
      clear_row(part, row);
    }
    ++part.count[bin + row + 1];
    float& depth = part.depth[bin + row];
    depth = depth < binned.depth[i] ? binned.depth[i] : depth;
  });
}

void BeamIndex::sort(int threads) {
  // Counts become places: those of a bin's beams, part by part.
  Part& whole = parts_.back();
  // Rows without beams share borders, behind the last row.
  clear_row(whole, rows());
  row_borders_.assign(rows(), static_cast<std::int32_t>(border(rows())));
  std::int32_t place = 0;
  for (std::size_t row = 0; row < rows(); ++row) {
    const bool is_used = std::any_of(parts_.begin(), parts_.end(),
                                     [&](const Part& part) { return part.row_used[row] != 0; });
    if (!is_used) continue;
    row_borders_[row] = static_cast<std::int32_t>(border(row));
    for (Part& part : parts_) {
      if (part.row_used[row] == 0) clear_row(part, row);
    }
    float* depths = whole.depth + border(row);
    for (const Part& part : std::span(parts_).first(parts_.size() - 1)) {
      for (std::size_t u = 0; u < bins(); ++u) {
        depths[u] = std::max(depths[u], part.depth[border(row) + u]);
      }
    }
    depth_.add_row(row, depths);

    whole.count[border(row)] = place;
    for (std::size_t u = 1; u <= bins(); ++u) {
      for (Part& part : parts_) {
        place += std::exchange(part.count[border(row) + u], place);
      }
    }
  }
  depth_.finish();
  for (const Part& part : parts_) has_cut_at_origin_ |= part.has_cut_at_origin;

  for (float* column : sorted_inverse_) std::fill_n(column + place, kPadding, 0.0F);
  // Each place moves on with its beams: in the end the last part's is the next bin's first.
  for_each_range(threads, parts_.size(), [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      Part& part = parts_[p];
      for (std::size_t i = part.first; i < part.last; ++i) {
        if (bin_[i] == kNoBin) continue;
        const std::size_t bin = bin_[i];
        const auto to = static_cast<std::size_t>(part.count[bin + (bin >> bin_bits_) + 1]++);
        sorted_number_[to] = numbers_.empty() ? static_cast<std::uint32_t>(i) : numbers_[i];
        for (std::size_t axis = 0; axis < 3; ++axis) {
          sorted_inverse_[axis][to] = inverse_[axis][i];
        }
      }
    }
  });

  sorted_ = {
      .origin = origin_,
      .origin_cell = origin_.array().floor().cast<std::int32_t>(),
      .bins = 1 << bin_bits_,
      .inverse = {sorted_inverse_[0], sorted_inverse_[1], sorted_inverse_[2]},
      .number = sorted_number_,
      .borders = whole.count,
      .row_borders = row_borders_.data(),
      .depth = whole.depth,
  };
}

bool BeamIndex::may_reach(const CellBox& box) const {
  std::array<cube_map::Slab, 3> slabs;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    slabs[axis] = cube_map::slab(box.min[at], box.max[at], origin_[at]);
  }
  for (int face = 0; face < cube_map::kFaces; ++face) {
    const auto print = cube_map::footprint(slabs, face, 1 << bin_bits_);
    if (print && depth_.reaches(face, print->u, print->v, print->near * (1 - cube_map::kWiden))) {
      return true;
    }
  }
  return false;
}

}  // namespace rmap
