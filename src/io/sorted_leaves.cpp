#include "io/sorted_leaves.hpp"

#include <algorithm>

namespace rmap {

std::vector<Leaf> sorted_leaves(const Grid& grid) {
  std::vector<Leaf> leaves;
  leaves.reserve(grid.leaf_count());
  grid.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaves.push_back(leaf);
    return true;
  });
  std::sort(leaves.begin(), leaves.end(),
            [](const Leaf& a, const Leaf& b) { return morton_less(a.origin, b.origin); });
  return leaves;
}

}  // namespace rmap
