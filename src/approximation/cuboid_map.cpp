#include "approximation/block_masks.hpp"
#include "approximation/cell_blocks.hpp"
#include "approximation/cell_boxes.hpp"
#include "approximation/cover.hpp"
#include "approximation/cover_tiles.hpp"
#include "approximation/dense_region.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include <rmap/approximate.hpp>
#include <rmap/cuboid_map.hpp>
#include <rmap/error.hpp>
#include <rmap/leaf.hpp>

namespace rmap {

namespace {

/// How far around a change boxes may move. docs/decisions/006 has the figures.
constexpr int kReach = 24;
/// Changes are taken together within cubes of so many cells.
constexpr std::int32_t kRegionEdge = 64;

/// The parts of a box outside another one that it overlaps, up to six.
std::vector<CellBox> without(CellBox box, const CellBox& hole) {
  std::vector<CellBox> parts;
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] < hole.min[axis]) {
      parts.push_back(box);
      parts.back().max[axis] = box.min[axis] = hole.min[axis];
    }
    if (box.max[axis] > hole.max[axis]) {
      parts.push_back(box);
      parts.back().min[axis] = box.max[axis] = hole.max[axis];
    }
  }
  return parts;
}

CoverLimits limits_of(const CuboidMapOptions& options) {
  // Checked by the rules of the approximation that this stands for.
  approximate({}, {.method = CuboidMethod::cover,
                   .outer = options.outer,
                   .inner = options.inner,
                   .max_false = std::nullopt,
                   .threads = options.threads});
  return {.outer = options.outer, .inner = options.inner};
}

}  // namespace

class CuboidMap::Implementation {
 public:
  Implementation(std::span<const CountedCell> cells, const CuboidMapOptions& options)
      : limits_(limits_of(options)), tree_(options.rtree) {
    check_cells(cells);
    for (const CountedCell& counted : cells) cells_.set(counted.cell, true);
    std::vector<RTree<std::uint32_t>::Item> items;
    for (const CellBox& box : cover_by_tiles(CellBlocks(cells), limits_, options.threads)) {
      items.push_back({box, next_++});
    }
    tree_ = RTree<std::uint32_t>::bulk_load(items, options.rtree);
  }

  void update(std::span<const CellState> states);
  void update(const Changes& changes);

  const BlockMasks& cells() const { return cells_; }
  const RTree<std::uint32_t>& tree() const { return tree_; }
  std::uint64_t revision = 0;

 private:
  struct Item {
    CellBox box;
    std::uint32_t number;
  };

  /// The region with a bit for each place; exact at limits_.outer cells from its border.
  DenseRegion dense(const CellBox& region) const;
  void carve(const CellBox& changed);
  void cover_again(const CellBox& changed);
  std::vector<Item> near(const CellBox& region) const;
  void insert(const CellBox& box) { tree_.insert(box, next_++); }
  void erase(const Item& item) {
    tree_.erase_if(item.box, [&](std::uint32_t number) { return number == item.number; });
  }

  CoverLimits limits_;
  BlockMasks cells_;
  RTree<std::uint32_t> tree_;  // payload: a number that tells equal boxes apart
  std::uint32_t next_ = 0;
};

std::vector<CuboidMap::Implementation::Item> CuboidMap::Implementation::near(
    const CellBox& region) const {
  std::vector<Item> items;
  tree_.overlapping(region, [&](const CellBox& box, std::uint32_t number) {
    items.push_back({box, number});
    return true;
  });
  // In one order, however the tree came about.
  std::sort(items.begin(), items.end(),
            [](const Item& a, const Item& b) { return a.number < b.number; });
  return items;
}

DenseRegion CuboidMap::Implementation::dense(const CellBox& region) const {
  std::vector<Cell> places;
  cells_.for_each(region, [&](const Cell& cell) { places.push_back(cell); });
  return DenseRegion(places, region, limits_);
}

// What is no longer allowed is cut out of the boxes that hold it.
void CuboidMap::Implementation::carve(const CellBox& changed) {
  const DenseRegion around = dense(grown_by(changed, limits_.outer));
  for (const Item& item : near(changed)) {
    const CellBox inside = intersection(item.box, changed);
    if (around.allowed().holds(around.to_local(inside))) continue;
    erase(item);
    for (const CellBox& part : without(item.box, changed)) insert(part);
  }
}

void CuboidMap::Implementation::cover_again(const CellBox& changed) {
  const CellBox region = grown_by(changed, kReach);
  // Boxes in the region may cover cells `inner` beyond it, and cells `outer` beyond allow some in
  // it.
  const CellBox room = grown_by(region, std::max(limits_.outer, limits_.inner));
  const DenseRegion dense = this->dense(room);
  BitGrid required = dense.none();
  const CellBox needed = grown_by(region, limits_.inner);
  cells_.for_each(needed, [&](const Cell& cell) { required.set(dense.to_local(cell)); });
  std::vector<Item> movable;
  std::vector<CellBox> first;
  for (const Item& item : near(grown_by(needed, limits_.inner))) {
    if (region.contains(item.box)) {
      movable.push_back(item);
      first.push_back(dense.to_local(item.box));
    } else {
      const CellBox covered = dense.to_local(grown_by(item.box, limits_.inner));
      const CellBox here = intersection(covered, dense.places());
      if (!here.empty()) required.reset(here);
    }
  }
  for (const Item& item : movable) erase(item);
  for (const CellBox& box : cover(dense.allowed(), required, limits_, first)) {
    insert(dense.to_map(box));
  }
}

void CuboidMap::Implementation::update(std::span<const CellState> states) {
  const auto key = [](const Cell& cell) {
    const Cell cube = cell.unaryExpr([](std::int32_t index) { return index & ~(kRegionEdge - 1); });
    return std::tuple(cube.z(), cube.y(), cube.x());
  };
  for (const CellState& state : states) {  // before anything changes
    const CountedCell cell{state.cell, 1};
    check_cells({&cell, 1});
  }
  std::map<std::tuple<std::int32_t, std::int32_t, std::int32_t>, CellBox> regions;
  for (const CellState& state : states) {
    if (cells_.contains(state.cell) == state.occupied) continue;
    cells_.set(state.cell, state.occupied);
    const auto [region, is_new] = regions.try_emplace(key(state.cell), box_of(state.cell));
    if (!is_new) region->second = united(region->second, box_of(state.cell));
  }
  // All boxes hold only what is allowed before any is moved.
  for (auto& [cube, changed] : regions) {
    changed = grown_by(changed, limits_.outer);
    carve(changed);
  }
  for (const auto& [cube, changed] : regions) cover_again(changed);
}

// A list that is not complete names every occupied cell of its blocks: the others are not.
void CuboidMap::Implementation::update(const Changes& changes) {
  if (changes.since > revision) {
    throw Error(ErrorKind::usage,
                fmt::format("the changes begin at revision {}, and the cuboids stand for revision "
                            "{}: what lies between is missing",
                            changes.since, revision));
  }
  std::vector<CellState> states;
  const auto forget = [&](const Cell& cell) { states.push_back({cell, false}); };
  if (!changes.blocks_complete) {
    cells_.for_each_block([&](const Cell& origin, const CellMask& cells) {
      cells.for_each([&](BlockPosition position) { forget(origin + block_offset(position)); });
    });
  } else if (!changes.complete) {
    for (const ChangedBlock& block : changes.blocks) {
      cells_.for_each({.min = block.origin, .max = block.origin + Cell::Constant(kBlockEdge)},
                      forget);
    }
  }
  // What is named as well is not forgotten.
  const auto less = [](const CellState& a, const CellState& b) {
    return morton_less(a.cell, b.cell);
  };
  std::sort(states.begin(), states.end(), less);
  std::vector<CellState> named = changes.cells;
  std::sort(named.begin(), named.end(), less);
  std::vector<CellState> all = named;
  std::set_difference(states.begin(), states.end(), named.begin(), named.end(),
                      std::back_inserter(all), less);
  update(all);
  revision = changes.revision;
}

CuboidMap::CuboidMap(std::span<const CountedCell> cells, const CuboidMapOptions& options)
    : implementation_(std::make_unique<Implementation>(cells, options)) {}

CuboidMap::CuboidMap(const Grid& grid, const CuboidMapOptions& options)
    : CuboidMap(occupied_cells(grid), options) {
  implementation_->revision = grid.revision();
}

CuboidMap::~CuboidMap() = default;
CuboidMap::CuboidMap(CuboidMap&&) noexcept = default;
CuboidMap& CuboidMap::operator=(CuboidMap&&) noexcept = default;

void CuboidMap::update(const Changes& changes) { implementation_->update(changes); }
void CuboidMap::update(std::span<const CellState> cells) { implementation_->update(cells); }
std::uint64_t CuboidMap::revision() const { return implementation_->revision; }
std::size_t CuboidMap::size() const { return implementation_->tree().size(); }

std::size_t CuboidMap::cell_count() const {
  return static_cast<std::size_t>(implementation_->cells().size());
}

std::vector<CountedCell> CuboidMap::cells() const {
  std::vector<CountedCell> cells;
  implementation_->cells().for_each_block([&](const Cell& origin, const CellMask& mask) {
    mask.for_each([&](BlockPosition position) {
      cells.push_back({Cell(origin + block_offset(position)), 1});
    });
  });
  return sorted_cells(std::move(cells));
}

std::vector<Cuboid> CuboidMap::cuboids() const {
  std::vector<Cuboid> cuboids;
  implementation_->tree().for_each([&](const CellBox& box, std::uint32_t) {
    std::uint64_t occupied = 0;
    implementation_->cells().for_each(box, [&](const Cell&) { ++occupied; });
    cuboids.push_back({box, occupied});
    return true;
  });
  return cuboids;
}

const RTree<std::uint32_t>& CuboidMap::tree() const { return implementation_->tree(); }

}  // namespace rmap
