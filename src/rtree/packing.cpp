#include "rtree/packing.hpp"

#include <algorithm>
#include <numeric>

namespace rmap {

namespace {

/// Twice the centre of a box: whole numbers, and within 32 bits for boxes within the limits.
using Center = std::array<std::int32_t, 3>;

Center center_of(const CellBox& box) {
  const Cell sum = box.min + box.max;
  return {sum.x(), sum.y(), sum.z()};
}

/// The smallest s with s^power >= value.
std::size_t root_above(std::size_t value, int power) {
  const auto reaches = [&](std::size_t root) {
    std::size_t product = 1;
    for (int i = 0; i < power; ++i) product *= root;
    return product >= value;
  };
  std::size_t root = 1;
  while (!reaches(root)) ++root;
  return root;
}

struct TileItem {
  Center center;
  std::uint32_t index;
};

class SortTileRecursive {
 public:
  explicit SortTileRecursive(std::size_t run) : run_(run) {}

  /// Cuts `part` along `axis` into slabs of whole runs, and orders each along the rest; within a
  /// run items follow the last axis.
  void order(std::span<TileItem> part, std::size_t axis) const {
    const std::size_t runs = (part.size() + run_ - 1) / run_;
    const std::size_t slabs = axis == 2 ? runs : root_above(runs, 3 - static_cast<int>(axis));
    const std::size_t slab = slabs == 0 ? run_ : (runs + slabs - 1) / slabs * run_;
    cut(part, slab, axis);
    for (std::size_t first = 0; first < part.size(); first += slab) {
      const std::span<TileItem> one = part.subspan(first, std::min(slab, part.size() - first));
      if (axis < 2) {
        order(one, axis + 1);
      } else {
        std::sort(one.begin(), one.end(), Less{axis});
      }
    }
  }

 private:
  // On a lattice many centres are equal on one axis: there the other axes keep neighbours together.
  struct Less {
    std::size_t axis;
    bool operator()(const TileItem& a, const TileItem& b) const {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t next = (axis + i) % 3;
        if (a.center[next] != b.center[next]) return a.center[next] < b.center[next];
      }
      return a.index < b.index;
    }
  };

  // Slabs as in the sorted part, each in some order: by halves, which costs less than to sort.
  static void cut(std::span<TileItem> part, std::size_t slab, std::size_t axis) {
    if (part.size() <= slab) return;
    const std::size_t slabs = (part.size() + slab - 1) / slab;
    const std::size_t half = slabs / 2 * slab;
    std::nth_element(part.begin(), part.begin() + static_cast<std::ptrdiff_t>(half), part.end(),
                     Less{axis});
    cut(part.first(half), slab, axis);
    cut(part.subspan(half), slab, axis);
  }

  std::size_t run_;
};

void order_by_tiles(std::span<const CellBox> boxes, std::size_t run,
                    std::span<std::uint32_t> order) {
  std::vector<TileItem> items;
  items.reserve(boxes.size());
  for (const std::uint32_t index : order) items.push_back({center_of(boxes[index]), index});
  SortTileRecursive(run).order(items, 0);
  std::transform(items.begin(), items.end(), order.begin(),
                 [](const TileItem& item) { return item.index; });
}

struct HilbertItem {
  HilbertPlace place;
  std::uint32_t index;
};

void order_by_hilbert(std::span<const CellBox> boxes, std::span<std::uint32_t> order) {
  constexpr std::uint32_t kSign = std::uint32_t{1} << 31;  // turns the order of signed numbers
  std::vector<HilbertItem> items;                          // into that of unsigned ones
  items.reserve(boxes.size());
  for (const std::uint32_t index : order) {
    const Center center = center_of(boxes[index]);
    items.push_back({hilbert_place({static_cast<std::uint32_t>(center[0]) ^ kSign,
                                    static_cast<std::uint32_t>(center[1]) ^ kSign,
                                    static_cast<std::uint32_t>(center[2]) ^ kSign}),
                     index});
  }
  std::sort(items.begin(), items.end(), [](const HilbertItem& a, const HilbertItem& b) {
    return a.place == b.place ? a.index < b.index : hilbert_less(a.place, b.place);
  });
  std::transform(items.begin(), items.end(), order.begin(),
                 [](const HilbertItem& item) { return item.index; });
}

}  // namespace

std::vector<std::uint32_t> packed_order(std::span<const CellBox> boxes, std::size_t run,
                                        Packing packing) {
  std::vector<std::uint32_t> order(boxes.size());
  std::iota(order.begin(), order.end(), 0u);
  if (packing == Packing::hilbert) {
    order_by_hilbert(boxes, order);
  } else {
    order_by_tiles(boxes, run, order);
  }
  return order;
}

std::size_t next_run(std::size_t remaining, std::size_t min, std::size_t max) {
  if (remaining <= max) return remaining;
  return remaining < max + min ? remaining - min : max;
}

HilbertPlace hilbert_place(std::array<std::uint32_t, 3> point) {
  auto& [x, y, z] = point;
  // From the largest cube down: undo the reflection or the exchange of axes of each sub-cube.
  for (std::uint32_t bit = std::uint32_t{1} << 31; bit > 1; bit >>= 1) {
    const std::uint32_t below = bit - 1;
    for (std::uint32_t* axis : {&x, &y, &z}) {
      if ((*axis & bit) != 0) {
        x ^= below;
      } else {
        const std::uint32_t exchange = (x ^ *axis) & below;
        x ^= exchange;
        *axis ^= exchange;
      }
    }
  }
  // Gray code to its rank.
  y ^= x;
  z ^= y;
  std::uint32_t flips = 0;
  for (std::uint32_t bit = std::uint32_t{1} << 31; bit > 1; bit >>= 1) {
    if ((z & bit) != 0) flips ^= bit - 1;
  }
  return {x ^ flips, y ^ flips, z ^ flips};
}

bool hilbert_less(const HilbertPlace& a, const HilbertPlace& b) {
  // The word with the highest differing bit decides; of equal ones the earlier.
  std::size_t word = 0;
  std::uint32_t highest = a[0] ^ b[0];
  for (const std::size_t other : {1u, 2u}) {
    const std::uint32_t difference = a[other] ^ b[other];
    if (highest < difference && highest < (highest ^ difference)) {
      word = other;
      highest = difference;
    }
  }
  return a[word] < b[word];
}

}  // namespace rmap
