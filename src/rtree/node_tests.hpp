#pragma once

#include <array>
#include <cstdint>

#include <rmap/beam.hpp>
#include <rmap/cell.hpp>
#include <rmap/rtree/node_pool.hpp>

namespace rmap {

/// What a search asks of all branches of a node at a time. Bit i of a mask stands
/// for branch i.
namespace node_tests {

/// One number for each branch; those beyond the node's count are not set.
using Measures = std::array<double, kMaxBranches>;

/// All branches of the node.
inline std::uint64_t all(const BranchColumns& columns) {
  return columns.count == 0 ? 0 : ~std::uint64_t{0} >> (kMaxBranches - columns.count);
}
/// Branches that share a cell with `region`, which is not empty.
std::uint64_t overlapping(const BranchColumns& columns, const CellBox& region);
/// Branches that lie in `region` as a whole.
std::uint64_t contained_in(const BranchColumns& columns, const CellBox& region);
/// Branches that hold `box` as a whole.
std::uint64_t enclosing(const BranchColumns& columns, const CellBox& box);
/// Branches with exactly this box.
std::uint64_t equal_to(const BranchColumns& columns, const CellBox& box);
/// The first item with exactly `box` at or below a node of a level, the leaf NodePool::kNone when
/// there is none: the search that asks the two above node by node.
struct ItemPlace {
  std::uint32_t leaf;
  int branch;
};
ItemPlace find_item(const NodePool& inner, const NodePool& leaves, std::uint32_t node, int level,
                    const CellBox& box);
/// Branches that `beam` crosses, with their parameters of entry: for each branch
/// bit for bit crossing(beam, box). Since t(k) is monotone, an MBRC is crossed
/// whenever a box in it is, and entered no later.
std::uint64_t crossed(const BranchColumns& columns, const Beam& beam, Measures& enter);
/// Branches that `beam` may cross, among them all that it does, with lower bounds of their
/// parameters of entry: without divisions. `inverse`: of the beam's direction, by axis.
std::uint64_t may_cross(const BranchColumns& columns, const Beam& beam, const Vector3d& inverse,
                        Measures& enter);

/// Squares of the distances from `point` (cell units) to the closed boxes; monotone, so
/// that of an MBRC is at most that of a box in it.
void squared_distances(const BranchColumns& columns, const Vector3d& point, Measures& squared);
/// Volumes of the boxes, and how much they would grow to hold `box` too.
void enlargements(const BranchColumns& columns, const CellBox& box, Measures& volume,
                  Measures& enlargement);

}  // namespace node_tests
}  // namespace rmap
