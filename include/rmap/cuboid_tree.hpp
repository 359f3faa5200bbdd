#pragma once

#include <cstdint>
#include <span>

#include <rmap/cuboids.hpp>
#include <rmap/rtree.hpp>

namespace rmap {

/// Cuboids in an R-tree, for queries by box, by nearest, and along a segment [RMAP 2.3, Table 1].
/// Payloads are places in the list. Boxes are in cells, in the frame of the cells.
///
///     const auto tree = rmap::cuboid_tree(cuboids, {.max_branches = 16});
///     tree.overlapping(robot, [&](const rmap::CellBox& box, std::uint32_t place) { ... });
///
/// Throws Error(input) when an option is out of range. Cost: sorting the boxes; memory:
/// tree.statistics().bytes_in_use.
RTree<std::uint32_t> cuboid_tree(std::span<const Cuboid> cuboids, const RTreeOptions& options = {});

}  // namespace rmap
