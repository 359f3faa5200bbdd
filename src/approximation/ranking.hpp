#pragma once

#include "approximation/cell_blocks.hpp"

#include <cstdint>
#include <span>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/cuboids.hpp>

namespace rmap {

/// A box of a ranked list.
struct RankedBox {
  CellBox box;
  std::uint64_t gain = 0;  ///< weight of the cells that no box before it covers
};

/// Orders boxes so that each next one covers most of what those before it left; those that cover
/// nothing more are left out. A box covers the cells at most `inner` from it; with inner 0 each is
/// shrunk to the cells that it covers anew, so that every prefix covers the same. Gains never rise.
/// Cost: each box is asked for its gain some times.
std::vector<RankedBox> ranked(const CellBlocks& cells, std::span<const CellBox> boxes,
                              CuboidWeight weight, int inner);

}  // namespace rmap
