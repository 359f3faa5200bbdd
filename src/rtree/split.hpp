#pragma once

#include <array>
#include <span>

#include <rmap/cell.hpp>
#include <rmap/rtree/node_pool.hpp>
#include <rmap/rtree/options.hpp>

namespace rmap {

/// For each branch of an overfull node whether it goes to the second of two groups.
using Partition = std::array<bool, kMaxBranches + 1>;

/// Parts `boxes`, at most kMaxBranches + 1, into two groups of at least
/// `min_branches` each by Guttman's quadratic or linear algorithm; there are at
/// least 2 * min_branches of them, and at least 2. Ties: the earlier boxes.
Partition partition(std::span<const CellBox> boxes, int min_branches, Split split);

}  // namespace rmap
