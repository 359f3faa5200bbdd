#include "rtree/node_tests.hpp"

#include <bit>
#include <type_traits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "rtree/node_tests.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace rmap::node_tests {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// What a branch's box is to a box that is asked for; on one axis, by the sides of both.
struct Overlapping {
  template <class V>
  auto operator()(V min, V max, V low, V high) const {
    return hn::And(hn::Gt(max, low), hn::Lt(min, high));
  }
};
struct ContainedIn {
  template <class V>
  auto operator()(V min, V max, V low, V high) const {
    return hn::Not(hn::Or(hn::Lt(min, low), hn::Gt(max, high)));
  }
};
struct Enclosing {
  template <class V>
  auto operator()(V min, V max, V low, V high) const {
    return hn::Not(hn::Or(hn::Gt(min, low), hn::Lt(max, high)));
  }
};
struct EqualTo {
  template <class V>
  auto operator()(V min, V max, V low, V high) const {
    return hn::And(hn::Eq(min, low), hn::Eq(max, high));
  }
};

// Read with the width with which they were stored: other widths would wait for the store.
template <class D>
std::uint64_t bits_of(D d, hn::Mask<D> mask) {
  using Bits = std::conditional_t<(hn::MaxLanes(D()) > 8), std::uint16_t, std::uint8_t>;
  std::array<std::uint8_t, sizeof(Bits)> bytes{};
  hn::StoreMaskBits(d, mask, bytes.data());
  return std::bit_cast<Bits>(bytes);
}

// Walks the branches from `first` on by vectors of at most kLanes, as long as these stay in the
// node's columns, which go on behind its branches; then by shorter ones. work(d, first) is given
// the tag of the vectors.
template <class T, std::size_t kLanes, class Work>
void by_vectors(const BranchColumns& columns, std::size_t first, const Work& work) {
  const hn::CappedTag<T, kLanes> d;
  const auto count = static_cast<std::size_t>(columns.count);
  const auto room = static_cast<std::size_t>(columns.min[1] - columns.min[0]);
  for (; first < count && first + hn::Lanes(d) <= room; first += hn::Lanes(d)) work(d, first);
  if constexpr (kLanes > 1) {
    if (first < count) by_vectors<T, kLanes / 2>(columns, first, work);
  }
}

template <class Relation>
std::uint64_t related(const BranchColumns& columns, const CellBox& box) {
  std::uint64_t mask = 0;
  by_vectors<std::int32_t, 16>(columns, 0, [&](auto d, std::size_t first) {
    const auto on_axis = [&](std::size_t axis) {
      const auto at = static_cast<int>(axis);
      const auto min = hn::LoadU(d, columns.min[axis] + first);
      const auto max = hn::Add(hn::LoadU(d, columns.max[axis] + first), hn::Set(d, columns.added));
      return Relation()(min, max, hn::Set(d, box.min[at]), hn::Set(d, box.max[at]));
    };
    const auto on_all = hn::And(on_axis(0), hn::And(on_axis(1), on_axis(2)));
    mask |= bits_of(d, on_all) << first;
  });
  return mask & all(columns);
}

std::uint64_t overlapping(const BranchColumns& columns, const CellBox& region) {
  return related<Overlapping>(columns, region);
}
std::uint64_t contained_in(const BranchColumns& columns, const CellBox& region) {
  return related<ContainedIn>(columns, region);
}
std::uint64_t enclosing(const BranchColumns& columns, const CellBox& box) {
  return related<Enclosing>(columns, box);
}
std::uint64_t equal_to(const BranchColumns& columns, const CellBox& box) {
  return related<EqualTo>(columns, box);
}

// Stays within one set of instructions: to choose it anew at each node would cost more than the
// node does.
ItemPlace find_item(const NodePool& inner, const NodePool& leaves, std::uint32_t node, int level,
                    const CellBox& box) {
  if (level == 0) {
    const std::uint64_t equal = equal_to(leaves.columns(node), box);
    return equal == 0 ? ItemPlace{NodePool::kNone, 0} : ItemPlace{node, std::countr_zero(equal)};
  }
  std::uint64_t left = enclosing(inner.columns(node), box);
  for (; left != 0; left &= left - 1) {
    const std::uint32_t child = inner.child(node, std::countr_zero(left));
    const ItemPlace found = find_item(inner, leaves, child, level - 1, box);
    if (found.leaf != NodePool::kNone) return found;
  }
  return {NodePool::kNone, 0};
}

// The branches between whose planes the beam runs for a while, with the parameters at which it
// enters them. parameter(d, distances, axis) is for planes at these distances from the origin;
// earliest(d, enter) and latest(d, leave) allow for its error.
template <class Parameter, class Enter, class Leave>
std::uint64_t met(const BranchColumns& columns, const Beam& beam, Measures& enter,
                  const Parameter& parameter, const Enter& earliest, const Leave& latest) {
  if (beam.crosses_nothing()) return 0;
  std::uint64_t mask = 0;
  by_vectors<double, 8>(columns, 0, [&](auto d, std::size_t first) {
    const hn::Rebind<std::int32_t, decltype(d)> di;
    auto entered = hn::Zero(d);
    auto left = hn::Set(d, 1.0);
    auto in_layer = hn::Eq(entered, entered);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<int>(axis);
      const auto min = hn::LoadU(di, columns.min[axis] + first);
      const auto max =
          hn::Add(hn::LoadU(di, columns.max[axis] + first), hn::Set(di, columns.added));
      const double direction = beam.direction()[at];
      if (direction == 0) {
        const auto layer = hn::Set(d, static_cast<double>(beam.origin_cell()[at]));
        in_layer = hn::And(in_layer, hn::And(hn::Le(hn::PromoteTo(d, min), layer),
                                             hn::Lt(layer, hn::PromoteTo(d, max))));
        continue;
      }
      const auto from_origin = [&](auto plane) {
        return hn::Sub(hn::PromoteTo(d, plane), hn::Set(d, beam.origin()[at]));
      };
      const auto at_near = parameter(d, from_origin(direction > 0 ? min : max), at);
      const auto at_far = parameter(d, from_origin(direction > 0 ? max : min), at);
      entered = hn::IfThenElse(hn::Lt(entered, at_near), at_near, entered);
      left = hn::IfThenElse(hn::Lt(at_far, left), at_far, left);
    }
    entered = earliest(d, entered);
    hn::StoreU(entered, d, enter.data() + first);
    mask |= bits_of(d, hn::And(in_layer, hn::Lt(entered, latest(d, left)))) << first;
  });
  return mask & all(columns);
}

std::uint64_t crossed(const BranchColumns& columns, const Beam& beam, Measures& enter) {
  const auto same = [](auto, auto value) { return value; };
  return met(
      columns, beam, enter,
      [&](auto d, auto distance, int axis) {
        return hn::Div(distance, hn::Set(d, beam.direction()[axis]));  // Beam::parameter
      },
      same, same);
}

// A product with the inverse is within 2^-51 of the quotient, relative to it.
std::uint64_t may_cross(const BranchColumns& columns, const Beam& beam, const Vector3d& inverse,
                        Measures& enter) {
  constexpr double kWiden = 0x1p-50;
  return met(
      columns, beam, enter,
      [&](auto d, auto distance, int axis) { return hn::Mul(distance, hn::Set(d, inverse[axis])); },
      [&](auto d, auto entered) { return hn::Mul(entered, hn::Set(d, 1 - kWiden)); },
      [&](auto d, auto left) { return hn::Mul(left, hn::Set(d, 1 + kWiden)); });
}

void enlargements(const BranchColumns& columns, const CellBox& box, Measures& volume,
                  Measures& enlargement) {
  by_vectors<double, 8>(columns, 0, [&](auto d, std::size_t first) {
    const hn::Rebind<std::int32_t, decltype(d)> di;
    auto own = hn::Set(d, 1.0);
    auto united = hn::Set(d, 1.0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<int>(axis);
      const auto from = hn::LoadU(di, columns.min[axis] + first);
      const auto to = hn::Add(hn::LoadU(di, columns.max[axis] + first), hn::Set(di, columns.added));
      const auto low = hn::Min(from, hn::Set(di, box.min[at]));
      const auto high = hn::Max(to, hn::Set(di, box.max[at]));
      own = hn::Mul(own, hn::Sub(hn::PromoteTo(d, to), hn::PromoteTo(d, from)));
      united = hn::Mul(united, hn::Sub(hn::PromoteTo(d, high), hn::PromoteTo(d, low)));
    }
    hn::StoreU(own, d, volume.data() + first);
    hn::StoreU(hn::Sub(united, own), d, enlargement.data() + first);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace rmap::node_tests
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rmap::node_tests {

HWY_EXPORT(overlapping);
HWY_EXPORT(contained_in);
HWY_EXPORT(enclosing);
HWY_EXPORT(equal_to);
HWY_EXPORT(find_item);
HWY_EXPORT(crossed);
HWY_EXPORT(may_cross);
HWY_EXPORT(enlargements);

std::uint64_t overlapping(const BranchColumns& columns, const CellBox& region) {
  return HWY_DYNAMIC_DISPATCH(overlapping)(columns, region);
}
std::uint64_t contained_in(const BranchColumns& columns, const CellBox& region) {
  return HWY_DYNAMIC_DISPATCH(contained_in)(columns, region);
}
std::uint64_t enclosing(const BranchColumns& columns, const CellBox& box) {
  return HWY_DYNAMIC_DISPATCH(enclosing)(columns, box);
}
std::uint64_t equal_to(const BranchColumns& columns, const CellBox& box) {
  return HWY_DYNAMIC_DISPATCH(equal_to)(columns, box);
}
ItemPlace find_item(const NodePool& inner, const NodePool& leaves, std::uint32_t node, int level,
                    const CellBox& box) {
  return HWY_DYNAMIC_DISPATCH(find_item)(inner, leaves, node, level, box);
}
std::uint64_t crossed(const BranchColumns& columns, const Beam& beam, Measures& enter) {
  return HWY_DYNAMIC_DISPATCH(crossed)(columns, beam, enter);
}
std::uint64_t may_cross(const BranchColumns& columns, const Beam& beam, const Vector3d& inverse,
                        Measures& enter) {
  return HWY_DYNAMIC_DISPATCH(may_cross)(columns, beam, inverse, enter);
}
void enlargements(const BranchColumns& columns, const CellBox& box, Measures& volume,
                  Measures& enlargement) {
  HWY_DYNAMIC_DISPATCH(enlargements)(columns, box, volume, enlargement);
}

namespace {

// A ternary, and not std::max of references, is what becomes a vector instruction; the same value
// as std::max(a, b), signed zeros included.
double larger(double a, double b) { return a < b ? b : a; }

}  // namespace

void squared_distances(const BranchColumns& columns, const Vector3d& point, Measures& squared) {
  const auto count = static_cast<std::size_t>(columns.count);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t* min = columns.min[axis];
    const std::int32_t* max = columns.max[axis];
    const double at = point[static_cast<int>(axis)];
    for (std::size_t i = 0; i < count; ++i) {
      const double below = static_cast<double>(min[i]) - at;
      const double above = at - static_cast<double>(max[i] + columns.added);
      const double outside = larger(larger(below, above), 0);
      squared[i] = axis == 0 ? outside * outside : squared[i] + outside * outside;
    }
  }
}

}  // namespace rmap::node_tests
#endif
