#include "grid/point_kernel.hpp"

#include <cmath>
#include <limits>

#include <rmap/beam.hpp>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "grid/point_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rmap {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Computes what a detail asks for. Multiplications and additions stand one by one: the definition
// rounds after each.
template <TileDetail kDetail>
class PointKernel {
 public:
  using Doubles = hn::ScalableTag<double>;
  using Wide = hn::Vec<Doubles>;
  using Bools = hn::Mask<Doubles>;
  using Floats = hn::Rebind<float, Doubles>;
  using Ints = hn::Rebind<std::int32_t, Doubles>;

  PointKernel(const PointKernelInput& input, PointTile& tile)
      : input_(input),
        tile_(tile),
        checks_range_(input.min_range > 0 ||
                      input.max_range < std::numeric_limits<double>::infinity()) {}

  /// The lanes from place `i` on; returns which are done.
  Bools compute(Wide x, Wide y, Wide z, std::size_t i, Bools& has_direction) const {
    const Doubles d;
    Bools good = hn::And(finite(x), hn::And(finite(y), finite(z)));
    Wide point[3] = {x, y, z};
    if (input_.moves) {
      for (std::size_t row = 0; row < 3; ++row) {
        const double* r = input_.map_from_points.data() + 4 * row;
        point[row] =
            hn::Add(hn::Add(hn::Add(hn::Mul(hn::Set(d, r[0]), x), hn::Mul(hn::Set(d, r[1]), y)),
                            hn::Mul(hn::Set(d, r[2]), z)),
                    hn::Set(d, r[3]));
      }
    }
    if (checks_range_) good = hn::And(good, in_range(point));
    const Wide zero = hn::Zero(d);
    has_direction = hn::FirstN(d, 0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Eigen::Index at = static_cast<Eigen::Index>(axis);
      const Wide end = hn::Mul(point[axis], hn::Set(d, input_.inverse));
      const Wide floor = hn::Floor(end);
      good = hn::And(good, hn::And(hn::Ge(floor, hn::Set(d, double{kMinCellIndex})),
                                   hn::Le(floor, hn::Set(d, double{kMaxCellIndex}))));
      hn::Store(hn::DemoteTo(Ints(), floor), Ints(), tile_.cell[axis].data() + i);
      if constexpr (kDetail == TileDetail::ends) hn::Store(end, d, tile_.end[axis].data() + i);
      if constexpr (kDetail == TileDetail::cells) continue;
      Wide direction = hn::Sub(end, hn::Set(d, input_.origin_in_cells[at]));
      direction =
          hn::IfThenElse(hn::Lt(hn::Abs(direction), hn::Set(d, kZeroDirection)), zero, direction);
      has_direction = hn::Or(has_direction, hn::Ne(direction, zero));
      hn::Store(hn::DemoteTo(Floats(), direction), Floats(), tile_.direction[axis].data() + i);
    }
    has_direction = hn::And(has_direction, good);
    return good;
  }

 private:
  static Bools finite(Wide v) {
    return hn::Le(hn::Abs(v), hn::Set(Doubles(), double{std::numeric_limits<float>::max()}));
  }

  Bools in_range(const Wide (&point)[3]) const {
    const Doubles d;
    const Wide dx = hn::Sub(point[0], hn::Set(d, input_.origin.x()));
    const Wide dy = hn::Sub(point[1], hn::Set(d, input_.origin.y()));
    const Wide dz = hn::Sub(point[2], hn::Set(d, input_.origin.z()));
    const Wide length =
        hn::Sqrt(hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz)));
    return hn::And(hn::Ge(length, hn::Set(d, input_.min_range)),
                   hn::Le(length, hn::Set(d, input_.max_range)));
  }

  const PointKernelInput& input_;
  PointTile& tile_;
  bool checks_range_;
};

std::uint64_t bits_of(hn::Mask<hn::ScalableTag<double>> mask) {
  const hn::ScalableTag<double> d;
  static_assert(hn::MaxLanes(d) <= 8, "one byte, read as it was stored: wider would wait for it");
  std::uint8_t bits = 0;
  hn::StoreMaskBits(d, mask, &bits);
  return bits;
}

template <TileDetail kDetail>
void compute_in_detail(const PointKernelInput& input, const float* points, std::size_t count,
                       PointTile& tile) {
  using Kernel = PointKernel<kDetail>;
  const typename Kernel::Doubles dd;
  const typename Kernel::Floats df;
  const std::size_t lanes = hn::Lanes(dd);
  const Kernel kernel(input, tile);
  for (std::size_t i = 0; i < count; i += lanes) {
    hn::Vec<typename Kernel::Floats> x, y, z;
    hn::LoadInterleaved3(df, points + 3 * i, x, y, z);
    typename Kernel::Bools has_direction;
    const auto done = kernel.compute(hn::PromoteTo(dd, x), hn::PromoteTo(dd, y),
                                     hn::PromoteTo(dd, z), i, has_direction);
    const std::uint64_t valid =
        count - i < lanes ? (std::uint64_t{1} << (count - i)) - 1 : ~std::uint64_t{0};
    tile.ends.set_group(i, bits_of(done) & valid);
    if constexpr (kDetail == TileDetail::cells) continue;
    tile.beams.set_group(i, bits_of(has_direction) & valid);
  }
}

void compute_tile(const PointKernelInput& input, const float* points, std::size_t count,
                  PointTile& tile) {
  switch (input.detail) {
    case TileDetail::cells:
      return compute_in_detail<TileDetail::cells>(input, points, count, tile);
    case TileDetail::directions:
      return compute_in_detail<TileDetail::directions>(input, points, count, tile);
    case TileDetail::ends:
      return compute_in_detail<TileDetail::ends>(input, points, count, tile);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rmap
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rmap {

HWY_EXPORT(compute_tile);

void compute_points(const PointKernelInput& input, const float* points, std::size_t count,
                    PointTile& tile) {
  HWY_DYNAMIC_DISPATCH(compute_tile)(input, points, count, tile);
}

}  // namespace rmap
#endif
