#include <rmap/compare.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

MapDifference compare(const Grid& a, const Grid& b) {
  if (a.options().resolution != b.options().resolution) {
    throw Error(ErrorKind::input,
                fmt::format("the maps cannot be compared cell by cell: their resolutions are {} and "
                            "{} m",
                            a.options().resolution, b.options().resolution));
  }
  MapDifference difference;
  a.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each([&](const Cell& cell, Value value) {
      const bool occupied_a = a.rule().occupied(value);
      const auto other = b.cell_value(cell);
      const bool occupied_b = other && b.rule().occupied(*other);
      difference.occupied_both += occupied_a && occupied_b ? 1 : 0;
      difference.occupied_only_a += occupied_a && !occupied_b ? 1 : 0;
      difference.occupied_only_b += !occupied_a && occupied_b ? 1 : 0;
      if (!other) {
        ++difference.only_a;
        return;
      }
      ++difference.both;
      difference.state_differs += occupied_a != occupied_b ? 1 : 0;
      difference.value_differs += value != *other ? 1 : 0;
      difference.max_difference = std::max(
          difference.max_difference, std::abs(probability_of(value) - probability_of(*other)));
    });
    return true;
  });
  b.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each([&](const Cell& cell, Value value) {
      if (a.cell_value(cell)) return;
      ++difference.only_b;
      difference.occupied_only_b += b.rule().occupied(value) ? 1 : 0;
    });
    return true;
  });
  return difference;
}

}  // namespace rmap
