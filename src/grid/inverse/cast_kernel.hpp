#pragma once

#include "grid/inverse/beam_index.hpp"

#include <rmap/function_ref.hpp>
#include <rmap/leaf.hpp>

namespace rmap {

/// The exact predicate: whether the beam with this number of its scan crosses `cell`.
using CrossesExactly = FunctionRef<bool(std::uint32_t beam, const Cell& cell)>;

/// Which cells of the block at `origin` some beam crosses, out of those in `asked`.
/// Single precision decides what is certain, `exactly` the rest.
CellMask crossed_in_block(const IndexedBeams& beams, const Cell& origin, const CellMask& asked,
                          CrossesExactly exactly);

}  // namespace rmap
