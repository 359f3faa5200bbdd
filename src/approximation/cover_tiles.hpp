#pragma once

#include "approximation/cell_blocks.hpp"
#include "approximation/cover_limits.hpp"

#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// How a large set of cells is cut. docs/decisions/006 has the figures.
struct Tiling {
  std::int32_t edge = 256;                     ///< of a tile, in cells
  std::int32_t halo = 8;                       ///< how far its boxes reach beyond it
  std::int64_t whole = std::int64_t{1} << 24;  ///< boxes of so many cells are not cut
};

/// Few boxes that cover a set of cells: cover() in one piece where its extent is small, else by
/// tiles that follow one another and may cover cells of their neighbours. Tiles that do not touch
/// run beside one another; the result is the same for any number of threads. Memory: by cells,
/// and some MB for each thread.
std::vector<CellBox> cover_by_tiles(const CellBlocks& cells, const CoverLimits& limits, int threads,
                                    const Tiling& tiling = {});

}  // namespace rmap
