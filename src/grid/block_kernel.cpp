#include "grid/block_kernel.hpp"

#include "grid/cell_places.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "grid/block_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rmap {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void end_blocks_of(const PointTile& tile, EndBlocks& blocks) {
  const hn::ScalableTag<std::uint32_t> d;
  using V = hn::Vec<decltype(d)>;
  const V edge_bits = hn::Set(d, kBlockEdge - 1);
  using Bits = std::conditional_t<hn::MaxLanes(d) <= 8, std::uint8_t, std::uint16_t>;
  static_assert(hn::MaxLanes(d) <= 16);
  blocks.changed.clear();
  for (std::size_t i = 0; i < tile.count; i += hn::Lanes(d)) {
    V hash = hn::Zero(d);
    V position = hn::Zero(d);
    auto same = hn::FirstN(d, i == 0 ? 0 : hn::Lanes(d));
    for (std::size_t axis = 3; axis-- > 0;) {
      const hn::RebindToSigned<decltype(d)> di;
      const V cell = hn::BitCast(d, hn::Load(di, tile.cell[axis].data() + i));
      hash = hn::Add(hash,
                     hn::Mul(hn::AndNot(edge_bits, cell), hn::Set(d, CellPlaces::kFactors[axis])));
      // Its three bits go to every third place: the Morton curve.
      const V bit0 = hn::And(cell, hn::Set(d, 1));
      const V bit1 = hn::ShiftLeft<2>(hn::And(cell, hn::Set(d, 2)));
      const V bit2 = hn::ShiftLeft<4>(hn::And(cell, hn::Set(d, 4)));
      position = hn::Or(hn::Add(position, position), hn::Or(bit0, hn::Or(bit1, bit2)));
      const auto before = hn::LoadU(di, tile.cell[axis].data() + (i == 0 ? 0 : i - 1));
      same = hn::And(same, hn::Eq(cell, hn::BitCast(d, before)));
    }
    Bits changed = 0;
    hn::StoreMaskBits(d, hn::Not(same), reinterpret_cast<std::uint8_t*>(&changed));
    blocks.changed.set_group(i, changed);
    hn::Store(hash, d, blocks.hash.data() + i);
    hn::Store(position, d, blocks.position.data() + i);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace rmap
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rmap {

HWY_EXPORT(end_blocks_of);

void find_end_blocks(const PointTile& tile, EndBlocks& blocks) {
  HWY_DYNAMIC_DISPATCH(end_blocks_of)(tile, blocks);
}

}  // namespace rmap
#endif
