#pragma once

#include "grid/inverse/cube_map.hpp"

#include <array>
#include <vector>

namespace rmap {

/// How deep the beams of a cube map reach, bin by bin, at every resolution: a
/// level has half the bins of the one below along each edge, and the largest depth
/// of the four that it covers. Level 0 has the bins themselves.
class DepthPyramid {
 public:
  /// `bins` along an edge of a face, a power of two.
  explicit DepthPyramid(int bins);

  /// Takes the depths of one row of bins; rows that are left out have no beams.
  void add_row(std::size_t row, const float* depths);
  /// Fills the levels above the lowest; no more rows may be added.
  void finish();

  /// Whether a beam in the rectangle of bins may be deeper than `depth`; false only when none is.
  bool reaches(int face, const cube_map::Bins& u, const cube_map::Bins& v, float depth) const;

 private:
  std::size_t place(int level, int face, int u, int v) const {
    const int edge = bins_ >> level;
    return first_[static_cast<std::size_t>(level)] +
           static_cast<std::size_t>((face * edge + v) * edge + u);
  }

  int bins_;  ///< along an edge of a face
  int levels_;
  std::array<std::size_t, 16> first_{};  ///< place of each level
  std::vector<float> depths_;
};

}  // namespace rmap
