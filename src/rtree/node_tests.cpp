#include "rtree/node_tests.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace rmap::node_tests {

namespace {

// A ternary, and not std::max of references, is what becomes a vector instruction; the same value
// as std::max(a, b) and std::min(a, b), signed zeros included.
double larger(double a, double b) { return a < b ? b : a; }
double smaller(double a, double b) { return b < a ? b : a; }

/// a && b, without the branch that keeps a loop from becoming vector code.
int both(bool a, bool b) { return static_cast<int>(a) & static_cast<int>(b); }

/// Bits of a word: not every vector unit can shift each lane by a number of its own.
template <class Word>
constexpr auto kBits = [] {
  std::array<Word, std::numeric_limits<Word>::digits> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = Word{1} << i;
  return bits;
}();

/// The mask of the branches for which hit(branch) holds. `Word` is as wide as what is compared,
/// so that vectors need no packing.
template <class Word, class Hit>
std::uint64_t where(std::size_t count, const Hit& hit) {
  constexpr std::size_t kWidth = std::numeric_limits<Word>::digits;
  std::uint64_t mask = 0;
  for (std::size_t first = 0; first < count; first += kWidth) {
    const std::size_t end = std::min(count - first, kWidth);
    Word word = 0;
    for (std::size_t i = 0; i < end; ++i) {
      word |= (Word{0} - static_cast<Word>(hit(first + i))) & kBits<Word>[i];  // no branch
    }
    mask |= std::uint64_t{word} << first;
  }
  return mask;
}

/// The mask of the branches for which test(axis, min, max) holds on all axes.
template <class Test>
std::uint64_t where_boxes(const BranchColumns& columns, const Test& test) {
  const BranchColumns c = columns;  // a copy, which nothing else can change
  return where<std::uint32_t>(static_cast<std::size_t>(c.count), [&test, c](std::size_t i) {
    return test(0, c.min[0][i], c.max[0][i] + c.added) &
           test(1, c.min[1][i], c.max[1][i] + c.added) &
           test(2, c.min[2][i], c.max[2][i] + c.added);
  });
}

}  // namespace

std::uint64_t all(const BranchColumns& columns) {
  return columns.count == 0 ? 0 : ~std::uint64_t{0} >> (kMaxBranches - columns.count);
}

std::uint64_t overlapping(const BranchColumns& columns, const CellBox& region) {
  return where_boxes(columns, [&](int axis, std::int32_t min, std::int32_t max) {
    return both(max > region.min[axis], min < region.max[axis]);
  });
}

std::uint64_t contained_in(const BranchColumns& columns, const CellBox& region) {
  return where_boxes(columns, [&](int axis, std::int32_t min, std::int32_t max) {
    return both(min >= region.min[axis], max <= region.max[axis]);
  });
}

std::uint64_t enclosing(const BranchColumns& columns, const CellBox& box) {
  return where_boxes(columns, [&](int axis, std::int32_t min, std::int32_t max) {
    return both(min <= box.min[axis], max >= box.max[axis]);
  });
}

std::uint64_t equal_to(const BranchColumns& columns, const CellBox& box) {
  return where_boxes(columns, [&](int axis, std::int32_t min, std::int32_t max) {
    return both(min == box.min[axis], max == box.max[axis]);
  });
}

std::uint64_t crossed(const BranchColumns& columns, const Beam& beam, Measures& enter) {
  if (beam.crosses_nothing()) return 0;
  const auto count = static_cast<std::size_t>(columns.count);
  std::uint64_t in_layer = all(columns);
  Measures leave;
  std::fill_n(enter.begin(), count, 0.0);
  std::fill_n(leave.begin(), count, 1.0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t* min = columns.min[static_cast<std::size_t>(axis)];
    const std::int32_t* max = columns.max[static_cast<std::size_t>(axis)];
    const std::int32_t added = columns.added;
    const double direction = beam.direction()[axis];
    if (direction == 0) {
      const std::int32_t layer = beam.origin_cell()[axis];
      in_layer &= where<std::uint32_t>(
          count, [&](std::size_t i) { return both(min[i] <= layer, layer < max[i] + added); });
      continue;
    }
    const bool forward = direction > 0;
    const std::int32_t* near = forward ? min : max;
    const std::int32_t* far = forward ? max : min;
    const std::int32_t near_added = forward ? 0 : added;
    const std::int32_t far_added = forward ? added : 0;
    const double origin = beam.origin()[axis];
    for (std::size_t i = 0; i < count; ++i) {
      // Beam::parameter, operation by operation.
      const double at_near = (static_cast<double>(near[i] + near_added) - origin) / direction;
      const double at_far = (static_cast<double>(far[i] + far_added) - origin) / direction;
      enter[i] = larger(enter[i], at_near);
      leave[i] = smaller(leave[i], at_far);
    }
  }
  return in_layer & where<std::uint64_t>(count, [&](std::size_t i) { return enter[i] < leave[i]; });
}

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

void enlargements(const BranchColumns& columns, const CellBox& box, Measures& volume,
                  Measures& enlargement) {
  const auto count = static_cast<std::size_t>(columns.count);
  Measures united_volume;
  std::fill_n(volume.begin(), count, 1.0);
  std::fill_n(united_volume.begin(), count, 1.0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::int32_t* min = columns.min[axis];
    const std::int32_t* max = columns.max[axis];
    const double low = box.min[static_cast<int>(axis)];
    const double high = box.max[static_cast<int>(axis)];
    for (std::size_t i = 0; i < count; ++i) {
      const double from = min[i];
      const double to = max[i] + columns.added;
      volume[i] *= to - from;
      united_volume[i] *= larger(to, high) - smaller(from, low);
    }
  }
  for (std::size_t i = 0; i < count; ++i) enlargement[i] = united_volume[i] - volume[i];
}

}  // namespace rmap::node_tests
