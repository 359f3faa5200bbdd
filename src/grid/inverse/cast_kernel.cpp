#include "grid/inverse/cast_kernel.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "grid/inverse/cast_kernel.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rmap {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A parameter t = (plane - origin) / direction comes with four roundings to single
// precision, 2^-22 of itself; within [0, 1] the difference of two is off by less than this.
constexpr float kUncertain = 0x1p-20F;

// The least distance of a plane but the origin's own: as parameter of a beam with a
// direction (2^-40 or more) far below kUncertain, of one without far beyond the end.
constexpr float kLeast = 1e-20F;

constexpr std::size_t kEdge = kBlockEdge;

using Floats = hn::ScalableTag<float>;
using Floats8 = hn::CappedTag<float, kEdge>;
using Ints8 = hn::RebindToSigned<Floats8>;
using Doubles8 = hn::CappedTag<double, kEdge>;

// The planes between which the cells of a block lie, on one axis, as seen from the origin.
struct AxisPlanes {
  alignas(32) std::array<float, kEdge> near;  // 0 in the origin's own layer
  alignas(32) std::array<float, kEdge> far;
  alignas(32) std::array<float, kEdge> low;  // of the slab, widened
  alignas(32) std::array<float, kEdge> high;
  float own_low = 0;  // the lower plane of the origin's own layer
  std::size_t own = kEdge;

  cube_map::Slab slab() const { return {low.front(), high.back()}; }
};

// `origin` is rounded only once its distance is taken.
void find_planes(std::int32_t first, double origin, std::int32_t origin_layer, AxisPlanes& planes) {
  const Doubles8 dd;
  const hn::Rebind<float, Doubles8> d;
  const auto tiny = hn::Set(d, cube_map::kTiny);
  for (std::size_t i = 0; i < kEdge; i += hn::Lanes(dd)) {
    const auto layer =
        hn::Add(hn::Iota(dd, static_cast<double>(i)), hn::Set(dd, static_cast<double>(first)));
    const auto from_origin = [&](auto plane) {
      return hn::DemoteTo(d, hn::Sub(plane, hn::Set(dd, origin)));
    };
    const auto low = from_origin(layer);
    const auto high = from_origin(hn::Add(layer, hn::Set(dd, 1.0)));
    hn::Store(low, d, planes.near.data() + i);
    hn::Store(high, d, planes.far.data() + i);
    hn::Store(hn::Sub(low, tiny), d, planes.low.data() + i);
    hn::Store(hn::Add(high, tiny), d, planes.high.data() + i);
  }
  const auto layers_to = [&](std::int64_t layer) {
    return static_cast<std::size_t>(std::clamp<std::int64_t>(layer - first, 0, kBlockEdge));
  };
  const std::size_t below = layers_to(origin_layer);
  const std::size_t above = layers_to(std::int64_t{origin_layer} + 1);
  for (std::size_t i = 0; i < below; ++i) {
    std::swap(planes.near[i], planes.far[i]);
    planes.near[i] = std::min(planes.near[i], -kLeast);
  }
  if (below < above) {
    planes.own = below;
    planes.own_low = std::min(planes.near[below], -kLeast);
    planes.near[below] = 0;
    planes.far[below] = std::max(planes.far[below], kLeast);
  }
  for (std::size_t i = above; i < kEdge; ++i) planes.near[i] = std::max(planes.near[i], kLeast);
}

// Bins of the cells of a block along u or v, by depth layer and layer on the axis.
class BinTable {
 public:
  void fill(std::size_t depth_layer, const cube_map::Depths& depths, const AxisPlanes& planes,
            int bins) {
    const Floats8 d;
    const Ints8 di;
    const auto zero = hn::Zero(d);
    const auto inverse_far = hn::Set(d, 1 / depths.far);
    const auto inverse_near =
        hn::Set(d, depths.near > 0 ? 1 / depths.near : std::numeric_limits<float>::infinity());
    const auto half = hn::Set(d, 0.5F * static_cast<float>(bins));
    const auto edge = hn::Set(d, static_cast<float>(bins));
    const auto last_bin = hn::Set(d, static_cast<float>(bins - 1));
    for (std::size_t i = 0; i < kEdge; i += hn::Lanes(d)) {
      const auto low = hn::Load(d, planes.low.data() + i);
      const auto high = hn::Load(d, planes.high.data() + i);
      // As cube_map::range and bins_of.
      const auto min = hn::Mul(low, hn::IfThenElse(hn::Ge(low, zero), inverse_far, inverse_near));
      const auto max = hn::Mul(high, hn::IfThenElse(hn::Gt(high, zero), inverse_near, inverse_far));
      const auto first = hn::Mul(hn::Add(min, hn::Set(d, 1 - cube_map::kWiden)), half);
      const auto last = hn::Mul(hn::Add(max, hn::Set(d, 1 + cube_map::kWiden)), half);
      const std::size_t at = depth_layer * kEdge + i;
      hn::Store(hn::ConvertTo(di, hn::Min(hn::Max(first, zero), edge)), di, first_.data() + at);
      hn::Store(hn::ConvertTo(di, hn::Min(hn::Max(last, hn::Set(d, -1.0F)), last_bin)), di,
                last_.data() + at);
    }
  }
  void clear(std::size_t depth_layer) {
    for (std::size_t i = 0; i < kEdge; ++i) {
      first_[depth_layer * kEdge + i] = 0;
      last_[depth_layer * kEdge + i] = -1;
    }
  }
  cube_map::Bins at(std::size_t depth_layer, std::size_t layer) const {
    return {first_[depth_layer * kEdge + layer], last_[depth_layer * kEdge + layer]};
  }

 private:
  alignas(32) std::array<std::int32_t, kEdge * kEdge> first_;
  alignas(32) std::array<std::int32_t, kEdge * kEdge> last_;
};

// The beams of one row of bins that a cell covers.
struct RowOfBeams {
  std::uint32_t begin, end;
  BlockPosition cell;
  float near;  // beams that end before it do not reach the cell
};

class BlockCaster {
 public:
  BlockCaster(const IndexedBeams& beams, const Cell& origin, CrossesExactly exactly)
      : beams_(beams), origin_(origin), exactly_(exactly) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      find_planes(origin[at], beams.origin[at], beams.origin_cell[at], planes_[axis]);
    }
  }

  CellMask cast(const CellMask& asked) {
    const std::array<cube_map::Slab, 3> block{planes_[0].slab(), planes_[1].slab(),
                                              planes_[2].slab()};
    for (int face = 0; face < cube_map::kFaces; ++face) {
      if (!cube_map::footprint(block, face, beams_.bins)) continue;
      const cube_map::Axes axes = cube_map::axes_of(face);
      filled_ = 0;
      asked.without(crossed_).for_each(
          [&](BlockPosition position) { cover(face, axes, position); });
      test_rows();
    }
    return crossed_;
  }

 private:
  using Vector = hn::Vec<Floats>;

  static constexpr std::size_t kMaxRows = 1024;
  static constexpr int kManyRows = 4;

  // Fills the tables for a depth layer unless they are.
  void fill(std::size_t layer, int face, const cube_map::Axes& axes) {
    if (((filled_ >> layer) & 1) != 0) return;
    filled_ |= 1U << layer;
    const AxisPlanes& planes = planes_[axes.depth];
    const cube_map::Depths depths = cube_map::depths({planes.low[layer], planes.high[layer]}, face);
    near_[layer] = depths.near * (1 - cube_map::kWiden);
    if (depths.far > 0) {
      u_.fill(layer, depths, planes_[axes.u], beams_.bins);
      v_.fill(layer, depths, planes_[axes.v], beams_.bins);
    } else {
      u_.clear(layer);
    }
  }

  // Notes the bins that a cell covers on a face. Their borders are asked for ahead of time, and
  // tested together with those of the other cells: each test by itself would wait for memory.
  void cover(int face, const cube_map::Axes& axes, BlockPosition position) {
    const std::array<std::size_t, 3> offset = offset_of(position);
    fill(offset[axes.depth], face, axes);
    const cube_map::Bins u = u_.at(offset[axes.depth], offset[axes.u]);
    const cube_map::Bins v = v_.at(offset[axes.depth], offset[axes.v]);
    if (u.first > u.last || v.first > v.last) return;
    if (v.last - v.first >= kManyRows) return cover_many(face, u, v, position);
    if (row_count_ + kManyRows > kMaxRows) test_rows();
    // One row or two, as a rule, and no telling which.
    const float near = near_[offset[axes.depth]];
    add_row(row_of(face, v.first), u, position, near);
    const std::size_t before_second = row_count_;
    add_row(row_of(face, v.last), u, position, near);
    row_count_ = before_second + (v.last > v.first ? 1 : 0);
    for (int row = v.first + 1; row < v.last; ++row) add_row(row_of(face, row), u, position, near);
  }

  void add_row(std::size_t row, const cube_map::Bins& u, BlockPosition position, float near) {
    const std::size_t border =
        static_cast<std::size_t>(beams_.row_borders[row]) + static_cast<std::size_t>(u.first);
    hwy::Prefetch(beams_.borders + border);
    hwy::Prefetch(beams_.depth + border);
    rows_[row_count_++] = {static_cast<std::uint32_t>(border),
                           static_cast<std::uint32_t>(u.last + 1 - u.first), position, near};
  }

  // A cell so near that it covers many rows: the first beams tell, as a rule.
  void cover_many(int face, const cube_map::Bins& u, const cube_map::Bins& v,
                  BlockPosition position) {
    for (int row_on_face = v.first; row_on_face <= v.last; ++row_on_face) {
      const std::size_t row = row_of(face, row_on_face);
      const std::int32_t* borders = beams_.borders + beams_.row_borders[row];
      test({static_cast<std::uint32_t>(borders[u.first]),
            static_cast<std::uint32_t>(borders[u.last + 1]), position, 0});
      if (crossed_.test(position)) return;
    }
  }

  void test_rows() {
    // Places of borders become places of beams, where one of them is deep enough: in half of the
    // rows that have beams all end before the cell, on its surface or on another.
    std::size_t count = 0;
    for (std::size_t i = 0; i < row_count_; ++i) {
      const RowOfBeams bins = rows_[i];
      const auto begin = static_cast<std::uint32_t>(beams_.borders[bins.begin]);
      const auto end = static_cast<std::uint32_t>(beams_.borders[bins.begin + bins.end]);
      rows_[count] = {begin, end, bins.cell, bins.near};
      count += reaches(bins.begin, bins.end, bins.near) ? 1 : 0;
    }
    for (std::size_t i = 0; i < count; ++i) {
      for (const float* inverse : beams_.inverse) hwy::Prefetch(inverse + rows_[i].begin);
    }
    for (std::size_t i = 0; i < count; ++i) test(rows_[i]);
    row_count_ = 0;
  }

  // Whether a beam in a row of bins may be deeper than `near`; three at most are looked at.
  bool reaches(std::size_t first, std::size_t bins, float near) const {
    const float* const depth = beams_.depth + first;
    const float deepest = std::max(std::max(depth[0], depth[bins - 1]), depth[bins / 2]);
    return (deepest > near) | (bins > 3);
  }

  // Nothing foretells the answer for a few beams, so it is noted without a branch.
  void test(const RowOfBeams& row) {
    const Floats d;
    const std::array<std::size_t, 3> offset = offset_of(row.cell);
    const bool own =
        planes_[0].own == offset[0] || planes_[1].own == offset[1] || planes_[2].own == offset[2];
    for (std::size_t i = row.begin; i < row.end; i += hn::Lanes(d)) {
      const Vector inside = own ? inside_of<true>(i, offset) : inside_of<false>(i, offset);
      const auto valid = hn::FirstN(d, row.end - i);
      const auto certain = hn::And(valid, hn::Gt(inside, hn::Set(d, kUncertain)));
      crossed_.set_if(row.cell, !hn::AllFalse(d, certain));
      const auto uncertain = hn::And(valid, hn::Le(hn::Abs(inside), hn::Set(d, kUncertain)));
      if (!hn::AllFalse(d, uncertain)) decide(i, uncertain, row.cell);
      if (i + hn::Lanes(d) < row.end && crossed_.test(row.cell)) return;
    }
  }

  void decide(std::size_t first, hn::Mask<Floats> uncertain, BlockPosition position) {
    if (crossed_.test(position)) return;
    std::uint64_t bits = 0;
    hn::StoreMaskBits(Floats(), uncertain, reinterpret_cast<std::uint8_t*>(&bits));
    for (; bits != 0; bits &= bits - 1) {
      const std::size_t beam = first + static_cast<std::size_t>(std::countr_zero(bits));
      if (exactly_(beams_.number[beam], origin_ + block_offset(position))) {
        return crossed_.set(position);
      }
    }
  }

  // How long the beams from i on are in a cell, as a parameter; negative for those that miss it.
  template <bool kOwn>  // whether the cell lies in the origin's own layer on some axis
  Vector inside_of(std::size_t i, const std::array<std::size_t, 3>& offset) const {
    const Floats d;
    Vector enter = hn::Zero(d);
    Vector leave = hn::Set(d, 1.0F);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const AxisPlanes& planes = planes_[axis];
      const Vector inverse = hn::LoadU(d, beams_.inverse[axis] + i);
      enter = hn::Max(enter, hn::Mul(hn::Set(d, planes.near[offset[axis]]), inverse));
      Vector exit = hn::Mul(hn::Set(d, planes.far[offset[axis]]), inverse);
      if (kOwn && planes.own == offset[axis]) {
        exit = hn::Max(exit, hn::Mul(hn::Set(d, planes.own_low), inverse));
      }
      leave = hn::Min(leave, exit);
    }
    return hn::Sub(leave, enter);
  }

  std::size_t row_of(int face, int row_on_face) const {
    return static_cast<std::size_t>(face) * static_cast<std::size_t>(beams_.bins) +
           static_cast<std::size_t>(row_on_face);
  }
  static std::array<std::size_t, 3> offset_of(BlockPosition position) {
    const Cell offset = block_offset(position);
    return {static_cast<std::size_t>(offset.x()), static_cast<std::size_t>(offset.y()),
            static_cast<std::size_t>(offset.z())};
  }

  const IndexedBeams& beams_;
  Cell origin_;
  CrossesExactly exactly_;
  std::array<AxisPlanes, 3> planes_;
  BinTable u_;
  BinTable v_;
  std::array<float, kEdge> near_;  ///< least depth of the layers, narrowed
  unsigned filled_ = 0;            ///< depth layers of the tables
  CellMask crossed_;
  std::size_t row_count_ = 0;
  /// First as places of borders: that of the first bin, and the number of bins.
  std::array<RowOfBeams, kMaxRows> rows_;
};

CellMask cast_block(const IndexedBeams& beams, const Cell& origin, const CellMask& asked,
                    CrossesExactly exactly) {
  return BlockCaster(beams, origin, exactly).cast(asked);
}

}  // namespace HWY_NAMESPACE
}  // namespace rmap
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rmap {

HWY_EXPORT(cast_block);

CellMask crossed_in_block(const IndexedBeams& beams, const Cell& origin, const CellMask& asked,
                          CrossesExactly exactly) {
  return HWY_DYNAMIC_DISPATCH(cast_block)(beams, origin, asked, exactly);
}

}  // namespace rmap
#endif
