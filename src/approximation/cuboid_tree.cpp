#include <vector>

#include <rmap/cuboid_tree.hpp>

namespace rmap {

RTree<std::uint32_t> cuboid_tree(std::span<const Cuboid> cuboids, const RTreeOptions& options) {
  std::vector<RTree<std::uint32_t>::Item> items;
  items.reserve(cuboids.size());
  for (const Cuboid& cuboid : cuboids) {
    items.push_back({cuboid.cells, static_cast<std::uint32_t>(items.size())});
  }
  return RTree<std::uint32_t>::bulk_load(items, options);
}

}  // namespace rmap
