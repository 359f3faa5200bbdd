#pragma once

#include "approximation/bit_grid.hpp"
#include "approximation/cover_limits.hpp"

#include <span>
#include <vector>

namespace rmap {

/// Few boxes inside `allowed` such that each cell of `required`, a subset of it, lies in one, or
/// at most limits.inner cells (Chebyshev) from one. Boxes may overlap. `required` stands empty
/// afterwards. The same for the same sets, always.
///
/// Begins with the boxes `first`, which lie inside `allowed`. Then a largest box from each cell
/// that is not covered yet, in scan order; then boxes without a cell of their own are dropped; then
/// each box is moved, in two passes, to where its neighbours need it least, so that some of those
/// can be dropped. docs/decisions/006 has the figures.
std::vector<CellBox> cover(const BitGrid& allowed, BitGrid& required, const CoverLimits& limits,
                           std::span<const CellBox> first);

}  // namespace rmap
