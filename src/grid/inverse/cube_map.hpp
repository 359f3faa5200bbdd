#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include <rmap/cell.hpp>

namespace rmap::cube_map {

// How directions from an origin fall into bins: on the six faces of a cube
// around it, each cut into rows of square bins. A face is named by the axis along
// which its beams are longest, and the sign there: 2 * axis + (negative). On it u
// and v are the other two components divided by the length along that axis, the
// depth; both run over [-1, 1], and v gives the row.

inline constexpr int kFaces = 6;

struct Axes {
  std::size_t depth, u, v;
};
constexpr Axes axes_of(int face) {
  constexpr std::array<Axes, 3> kAxes{{{0, 1, 2}, {1, 0, 2}, {2, 0, 1}}};
  return kAxes[static_cast<std::size_t>(face / 2)];
}
constexpr bool negative(int face) { return face % 2 == 1; }

/// Single precision gives u and v of beams and of boxes with an error below
/// 2^-20: rectangles are wider by that, so that no beam is missed.
inline constexpr float kWiden = 4e-6F;
/// Distances below it are lost in single precision where quotients of them count.
inline constexpr float kTiny = 1e-30F;

/// The planes of a box on one axis, as seen from the origin, cell units.
struct Slab {
  float low, high;
};
inline Slab slab(double low, double high, double origin) {
  return {static_cast<float>(low - origin) - kTiny, static_cast<float>(high - origin) + kTiny};
}

/// The part of a slab that lies on a face's side of the origin, as depths; nothing when far <= 0.
struct Depths {
  float near, far;
};
inline Depths depths(const Slab& slab, int face) {
  const float near = negative(face) ? -slab.high : slab.low;
  const float far = negative(face) ? -slab.low : slab.high;
  return {near > 0 ? near : 0, far};
}

/// The range of u (or v) of a slab between two depths.
struct Range {
  float min, max;
};
inline Range range(const Slab& slab, const Depths& depths) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const float min = slab.low >= 0     ? slab.low / depths.far
                    : depths.near > 0 ? slab.low / depths.near
                                      : -kInfinity;
  const float max = slab.high <= 0    ? slab.high / depths.far
                    : depths.near > 0 ? slab.high / depths.near
                                      : kInfinity;
  return {min, max};
}

/// The bins from `first` to `last` along an edge of a face; none when last < first.
struct Bins {
  int first, last;
};
inline Bins bins_of(const Range& range, int bins) {
  const float half = 0.5F * static_cast<float>(bins);
  const float last = static_cast<float>(bins - 1);
  // Clamped as numbers, since infinities are no integers; outside the face no bin is left.
  const float first_bin = std::clamp((range.min + (1 - kWiden)) * half, 0.0F, last + 1);
  const float last_bin = std::clamp((range.max + (1 + kWiden)) * half, -1.0F, last);
  return {static_cast<int>(first_bin), last_bin < 0 ? -1 : static_cast<int>(last_bin)};
}

/// What a box covers of a face.
struct Footprint {
  float near;  ///< its least depth there
  Bins u, v;
};
/// Nothing when the box, one slab an axis, does not lie on the face.
inline std::optional<Footprint> footprint(const std::array<Slab, 3>& box, int face, int bins) {
  const Axes axes = axes_of(face);
  const Depths within = depths(box[axes.depth], face);
  if (within.far <= 0) return std::nullopt;
  const Bins u = bins_of(range(box[axes.u], within), bins);
  if (u.first > u.last) return std::nullopt;
  const Bins v = bins_of(range(box[axes.v], within), bins);
  if (v.first > v.last) return std::nullopt;
  return Footprint{within.near, u, v};
}

}  // namespace rmap::cube_map
