#include "approximation/cover_tiles.hpp"

#include "approximation/cell_boxes.hpp"
#include "approximation/cover.hpp"
#include "approximation/dense_region.hpp"
#include "approximation/task_order.hpp"
#include "grid/cell_places.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <tuple>

namespace rmap {

namespace {

struct Tile {
  Cell place;    ///< in tiles from the lowest on
  CellBox home;  ///< no larger than its cells need
  std::size_t cells = 0;
};

class TileCover {
 public:
  TileCover(const CellBlocks& cells, const CoverLimits& limits, const Tiling& tiling)
      : cells_(cells), limits_(limits), tiling_(tiling), done_(cells.size(), 0) {
    find_tiles();
    boxes_.resize(tiles_.size());
  }

  std::vector<CellBox> run(int threads) {
    run_in_order(threads, before(), [&](std::size_t tile) { cover_tile(tile); });
    std::vector<CellBox> all;
    for (const auto& boxes : boxes_) all.insert(all.end(), boxes.begin(), boxes.end());
    return all;
  }

 private:
  void find_tiles();
  std::vector<std::vector<std::size_t>> before() const;
  void cover_tile(std::size_t index);

  const CellBlocks& cells_;
  const CoverLimits& limits_;
  const Tiling& tiling_;
  std::vector<Tile> tiles_;
  std::vector<std::uint8_t> done_;  // by cell; a tile touches those of its own and of its halo
  std::vector<std::vector<CellBox>> boxes_;
};

// Tiles that touch follow one another by the parity of their places, so that many do not wait; of
// those that do not touch, the largest first, so that none is left for the end.
void TileCover::find_tiles() {
  const auto scan_order = [](const Cell& a, const Cell& b) {
    return std::tuple(a.z(), a.y(), a.x()) < std::tuple(b.z(), b.y(), b.x());
  };
  std::map<Cell, Tile, decltype(scan_order)> tiles(scan_order);
  const auto place_of = [&](const Cell& cell) -> Cell {
    return (cell - cells_.bounds().min) / tiling_.edge;
  };
  const auto add = [&](const CellBox& box, std::size_t count) {
    const Cell place = place_of(box.min);
    Tile& tile = tiles.try_emplace(place, Tile{place, box, 0}).first->second;
    tile.home = united(tile.home, box);
    tile.cells += count;
  };
  for (const CellBlocks::Block& block : cells_.blocks()) {
    const CellBox box = bounds_of(block);
    if (place_of(box.min) == place_of(box.max - Cell::Ones())) {
      add(box, block.cells.count());
    } else {
      block.cells.for_each(
          [&](BlockPosition at) { add(box_of(block.origin + block_offset(at)), 1); });
    }
  }
  for (const auto& [place, found] : tiles) tiles_.push_back(found);
  const auto parity = [](const Tile& one) {
    return (one.place.x() & 1) | (one.place.y() & 1) << 1 | (one.place.z() & 1) << 2;
  };
  std::stable_sort(tiles_.begin(), tiles_.end(), [&](const Tile& a, const Tile& b) {
    return parity(a) != parity(b) ? parity(a) < parity(b) : a.cells > b.cells;
  });
}

std::vector<std::vector<std::size_t>> TileCover::before() const {
  CellPlaces places(tiles_.size());
  const auto place_of = [&](std::uint32_t i) -> const Cell& { return tiles_[i].place; };
  std::vector<std::vector<std::size_t>> before(tiles_.size());
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    const Cell& place = tiles_[i].place;
    for (int neighbour = 0; neighbour < 27; ++neighbour) {
      const Cell step(neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1);
      if (const auto earlier = places.find(place + step, place_of)) before[i].push_back(*earlier);
    }
    places.add(place, CellPlaces::hash_of(place), place_of);
  }
  return before;
}

void TileCover::cover_tile(std::size_t index) {
  const CellBox& home = tiles_[index].home;
  const CellBox region = intersection(grown_by(home, tiling_.halo), cells_.bounds());
  std::vector<Cell> places;
  cells_.for_each(region, [&](const Cell& cell, std::size_t) { places.push_back(cell); });
  const DenseRegion dense(places, region, limits_);
  BitGrid required = dense.none();
  cells_.for_each(home, [&](const Cell& cell, std::size_t number) {
    if (done_[number] == 0) required.set(dense.to_local(cell));
  });
  for (const CellBox& box : cover(dense.allowed(), required, limits_, {})) {
    boxes_[index].push_back(dense.to_map(box));
    const CellBox covered = grown_by(boxes_[index].back(), limits_.inner);
    cells_.for_each(intersection(covered, region),
                    [&](const Cell&, std::size_t number) { done_[number] = 1; });
  }
}

}  // namespace

std::vector<CellBox> cover_by_tiles(const CellBlocks& cells, const CoverLimits& limits, int threads,
                                    const Tiling& tiling) {
  if (cells.size() == 0) return {};
  Tiling used = tiling;
  const auto extent = cells.bounds().extent();
  if (static_cast<double>(extent.x()) * static_cast<double>(extent.y()) *
          static_cast<double>(extent.z()) <=
      static_cast<double>(tiling.whole)) {
    used.edge = static_cast<std::int32_t>(extent.maxCoeff());
  }
  return TileCover(cells, limits, used).run(threads);
}

}  // namespace rmap
