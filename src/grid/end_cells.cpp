#include "grid/end_cells.hpp"

#include "grid/block_kernel.hpp"
#include "grid/nearest_ends.hpp"
#include "grid/parallel.hpp"

#include <algorithm>
#include <optional>

namespace rmap {

namespace {

// What one thread gathers.
struct Share {
  EndCells ends;
  std::optional<NearestEnds> nearest;  ///< with Beams::per_end_cell
};

// Fewer are not worth another thread.
constexpr std::size_t kLeastTiles = 8;

std::size_t tiles_of(const BeamGroup& group) {
  return (group.size + PointTile::kSize - 1) / PointTile::kSize;
}

std::size_t ranges_of(const BeamGroup& group, int threads) {
  return range_count(threads, tiles_of(group), kLeastTiles);
}

// work(range, begin, end) over the places of a group, ranges starting with whole tiles.
template <class Work>
void for_each_range_of(const BeamGroup& group, int threads, const Work& work) {
  for_each_range(threads, tiles_of(group), kLeastTiles,
                 [&](std::size_t range, std::size_t begin, std::size_t end) {
                   work(range, begin * PointTile::kSize,
                        std::min(end * PointTile::kSize, group.size));
                 });
}

}  // namespace

EndCells gather_end_cells(const ScanBeams& beams, std::span<const BeamGroup> groups,
                          BeamIndex* index) {
  const int threads = beams.options().threads;
  const bool chooses = beams.options().beams == Beams::per_end_cell;
  const TileDetail detail = chooses            ? TileDetail::ends
                            : index != nullptr ? TileDetail::directions
                                               : TileDetail::cells;
  std::size_t ranges = 1;
  for (const BeamGroup& group : groups) ranges = std::max(ranges, ranges_of(group, threads));
  std::vector<Share> shares(ranges);
  for (Share& share : shares) {
    if (chooses) share.nearest.emplace(beams);
  }
  for (const BeamGroup& group : groups) {
    for_each_range_of(group, threads, [&](std::size_t range, std::size_t begin, std::size_t end) {
      Share& share = shares[range];
      TileLoader loader(beams, group.origin, detail);
      for_each_tile(group, begin, end, loader, [&](const PointTile& tile, std::size_t place) {
        EndBlocks blocks;
        find_end_blocks(tile, blocks);
        // Neighbours often end in one cell.
        tile.ends.run_starts(blocks.changed).for_each([&](std::size_t i) {
          share.ends.cells.add(block_origin(tile.cell_of(i)), blocks.hash[i], blocks.position[i]);
        });
        share.ends.inserted += tile.ends.count();
        if (index != nullptr) index->add(tile, place, range);
        if (!chooses) return;
        share.nearest->add(tile, blocks);
        tile.cuts.for_each([&](std::size_t i) { share.ends.chosen.push_back(tile.number(i)); });
      });
      share.ends.cut += loader.cut();
      share.ends.skipped += loader.skipped();
    });
  }

  EndCells all = std::move(shares.front().ends);
  for (const Share& share : std::span(shares).subspan(1)) {
    all.cells.add(share.ends.cells);
    all.inserted += share.ends.inserted;
    all.cut += share.ends.cut;
    all.skipped += share.ends.skipped;
    all.chosen.insert(all.chosen.end(), share.ends.chosen.begin(), share.ends.chosen.end());
    if (chooses) shares.front().nearest->add(*share.nearest);
  }
  if (chooses) {
    const std::vector<std::uint32_t> kept = shares.front().nearest->numbers();
    all.chosen.insert(all.chosen.end(), kept.begin(), kept.end());
    std::sort(all.chosen.begin(), all.chosen.end());
  }
  return all;
}

BeamIndex index_for(const ScanBeams& beams, const BeamGroup& group) {
  return BeamIndex(beams.lattice().to_cells(group.origin), group.numbers, group.size,
                   ranges_of(group, beams.options().threads));
}

void index_beams(const ScanBeams& beams, const BeamGroup& group, BeamIndex& index) {
  for_each_range_of(
      group, beams.options().threads, [&](std::size_t range, std::size_t begin, std::size_t end) {
        TileLoader loader(beams, group.origin, TileDetail::directions);
        for_each_tile(group, begin, end, loader, [&](const PointTile& tile, std::size_t place) {
          index.add(tile, place, range);
        });
      });
}

}  // namespace rmap
