#include "grid/inverse/depth_pyramid.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

namespace rmap {

DepthPyramid::DepthPyramid(int bins)
    : bins_(bins), levels_(std::countr_zero(static_cast<unsigned>(bins))) {
  assert(std::has_single_bit(static_cast<unsigned>(bins)) && bins >= 2);
  std::size_t size = 0;
  for (int level = 0; level <= levels_; ++level) {
    first_[static_cast<std::size_t>(level)] = size;
    const auto edge = static_cast<std::size_t>(bins >> level);
    size += cube_map::kFaces * edge * edge;
  }
  depths_.assign(size, 0);
}

void DepthPyramid::add_row(std::size_t row, const float* depths) {
  const int face = static_cast<int>(row) / bins_;
  const int v = static_cast<int>(row) % bins_;
  std::copy_n(depths, bins_, depths_.data() + place(0, face, 0, v));
}

void DepthPyramid::finish() {
  for (int level = 1; level <= levels_; ++level) {
    const int edge = bins_ >> level;
    for (int face = 0; face < cube_map::kFaces; ++face) {
      for (int v = 0; v < edge; ++v) {
        const float* low = depths_.data() + place(level - 1, face, 0, 2 * v);
        const float* high = depths_.data() + place(level - 1, face, 0, 2 * v + 1);
        float* above = depths_.data() + place(level, face, 0, v);
        for (std::size_t u = 0; u < static_cast<std::size_t>(edge); ++u) {
          above[u] = std::max(std::max(low[2 * u], low[2 * u + 1]),
                              std::max(high[2 * u], high[2 * u + 1]));
        }
      }
    }
  }
}

bool DepthPyramid::reaches(int face, const cube_map::Bins& u, const cube_map::Bins& v,
                           float depth) const {
  // At this level the rectangle is at most three bins wide.
  const auto span = static_cast<unsigned>(std::max(u.last - u.first, v.last - v.first));
  const int level = std::clamp(static_cast<int>(std::bit_width(span)) - 1, 0, levels_);
  for (int row = v.first >> level; row <= v.last >> level; ++row) {
    for (int bin = u.first >> level; bin <= u.last >> level; ++bin) {
      if (depths_[place(level, face, bin, row)] > depth) return true;
    }
  }
  return false;
}

}  // namespace rmap
