#include "grid/inverse/binning_kernel.hpp"

#include "grid/inverse/beam_index.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "grid/inverse/binning_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rmap {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void bin_tile(const PointTile& tile, int bins, BinnedTile& binned,
              const std::array<float*, 3>& inverse) {
  const hn::ScalableTag<float> d;
  const hn::RebindToSigned<decltype(d)> di;
  const hn::RebindToUnsigned<decltype(d)> du;
  using V = hn::Vec<decltype(d)>;
  const V one = hn::Set(d, 1.0F);
  const V zero = hn::Zero(d);
  const V half = hn::Set(d, 0.5F * static_cast<float>(bins));
  const auto last = hn::Set(di, bins - 1);

  for (std::size_t i = 0; i < tile.count; i += hn::Lanes(d)) {
    const V x = hn::Load(d, tile.direction[0].data() + i);
    const V y = hn::Load(d, tile.direction[1].data() + i);
    const V z = hn::Load(d, tile.direction[2].data() + i);
    const V infinite = hn::Set(d, BeamIndex::kInfiniteInverse);
    std::size_t axis = 0;
    for (const V& component : {x, y, z}) {
      const V inverted = hn::IfThenElse(hn::Eq(component, zero), infinite, hn::Div(one, component));
      hn::StoreU(inverted, d, inverse[axis++] + i);
    }

    const auto x_longest = hn::And(hn::Ge(hn::Abs(x), hn::Abs(y)), hn::Ge(hn::Abs(x), hn::Abs(z)));
    const auto y_longer = hn::Ge(hn::Abs(y), hn::Abs(z));
    const V along = hn::IfThenElse(x_longest, x, hn::IfThenElse(y_longer, y, z));
    const V depth = hn::Abs(along);
    // Axes as in cube_map::axes_of.
    const V scale = hn::Div(one, depth);
    const V u = hn::Mul(hn::IfThenElse(x_longest, y, x), scale);
    const V v = hn::Mul(hn::IfThenElse(hn::Or(x_longest, y_longer), z, y), scale);
    const auto bin_of = [&](V at) {
      const auto bin = hn::ConvertTo(di, hn::Mul(hn::Add(at, one), half));
      return hn::Min(hn::Max(bin, hn::Zero(di)), last);
    };
    const auto face_axis = hn::IfThenElse(
        hn::RebindMask(di, x_longest), hn::Zero(di),
        hn::IfThenElse(hn::RebindMask(di, y_longer), hn::Set(di, 2), hn::Set(di, 4)));
    const auto sign =
        hn::IfThenElse(hn::RebindMask(di, hn::Lt(along, zero)), hn::Set(di, 1), hn::Zero(di));
    const auto face = hn::Add(face_axis, sign);
    const auto row = hn::Add(hn::Mul(face, hn::Set(di, bins)), bin_of(v));
    const auto bin = hn::Add(hn::Mul(row, hn::Set(di, bins)), bin_of(u));
    hn::Store(hn::BitCast(du, bin), du, binned.bin.data() + i);
    hn::Store(depth, d, binned.depth.data() + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rmap
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rmap {

HWY_EXPORT(bin_tile);

void bin_beams(const PointTile& tile, int bins, BinnedTile& binned,
               const std::array<float*, 3>& inverse) {
  HWY_DYNAMIC_DISPATCH(bin_tile)(tile, bins, binned, inverse);
}

}  // namespace rmap
#endif
