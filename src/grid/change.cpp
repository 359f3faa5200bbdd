#include "grid/implementation.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

void sort_unique(std::vector<Cell>& cells) {
  std::sort(cells.begin(), cells.end(), morton_less);
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
}

void require_probability(double probability) {
  if (probability >= 0 && probability <= 1) return;
  throw Error(ErrorKind::input,
              fmt::format("the probability is {}: it must lie in 0 to 1", probability));
}

[[noreturn]] void refuse_beyond_limits(const char* what, const Cell& place) {
  throw Error(
      ErrorKind::limit,
      fmt::format("the {} at ({}, {}, {}) is beyond the limits: indices of cells must lie in "
                  "{} to {}",
                  what, place.x(), place.y(), place.z(), kMinCellIndex, kMaxCellIndex));
}

void require_blocks(std::span<const BlockValues> blocks) {
  const Cell* before = nullptr;
  for (const auto& [origin, cells, values] : blocks) {
    if (!within_limits(origin)) refuse_beyond_limits("block", origin);
    if (origin != block_origin(origin) || values.size() != cells.count()) {
      throw Error(
          ErrorKind::input,
          fmt::format("the block at ({}, {}, {}) gets {} values for {} cells: it must start at "
                      "multiples of {} and have one value for each cell",
                      origin.x(), origin.y(), origin.z(), values.size(), cells.count(),
                      kBlockEdge));
    }
    if (before != nullptr && !morton_less(*before, origin)) {
      throw Error(
          ErrorKind::input,
          fmt::format("the block at ({}, {}, {}) comes behind the one at ({}, {}, {}): "
                      "blocks must come in Morton order, each once",
                      origin.x(), origin.y(), origin.z(), before->x(), before->y(), before->z()));
    }
    before = &origin;
  }
}

// The cells of a leaf that lie in `region`.
CellMask cells_within(const Leaf& leaf, const CellBox& region) {
  if (region.contains(leaf.box())) return leaf.cells();
  CellMask within;
  leaf.cells().for_each([&](BlockPosition position) {
    if (region.contains(Cell(leaf.origin + block_offset(position)))) within.set(position);
  });
  return within;
}

}  // namespace

void Grid::Implementation::write(std::span<const LeafValues> leaves) {
  const auto set = [&](LeafId id, const LeafValues& leaf, const CellMask& created) {
    count_new_cells(created.count());
    update(id, leaf.origin, leaf.cells, created,
           [value = leaf.values](const Cell&, Value) mutable { return *value++; });
  };
  std::vector<MarkedLeaf> missing;
  std::vector<const LeafValues*> values;
  for (const LeafValues& leaf : leaves) {
    if (const auto id = store->find(leaf.origin)) {
      set(*id, leaf, store->add_missing(*id, leaf.cells, rule.prior()));
    } else {
      missing.push_back({0, leaf.origin, leaf.cells});
      values.push_back(&leaf);
    }
  }
  store->add_leaves(missing, rule.prior());
  for (std::size_t i = 0; i < missing.size(); ++i) set(missing[i].id, *values[i], missing[i].cells);
}

std::size_t Grid::Implementation::remove_cells(const CellBox& region,
                                               FunctionRef<bool(Value)> drop) {
  struct Removal {
    LeafId id;
    Cell origin;
    CellMask cells;
  };
  std::vector<Removal> removals;
  store->visit(region, [&](LeafId id, const Leaf& leaf) {
    const CellMask within = cells_within(leaf, region);
    CellMask dropped;
    const Value* value = leaf.values();
    leaf.cells().for_each([&](BlockPosition position) {
      if (within.test(position) && drop(*value)) {
        dropped.set(position);
        if (rule.occupied(*value)) log.flipped(leaf.origin + block_offset(position));
      }
      ++value;
    });
    if (!dropped.none()) removals.push_back({id, leaf.origin, dropped});
    return true;
  });

  std::size_t removed = 0;
  std::vector<Cell> blocks;
  for (const Removal& removal : removals) {
    removed += removal.cells.count();
    blocks.push_back(block_origin(removal.origin));
    store->remove(removal.id, removal.origin, removal.cells);
  }
  sort_unique(blocks);
  for (const Cell& block : blocks) log.lost_cells(block);
  cell_count -= removed;
  return removed;
}

void Grid::set(const Cell& cell, double probability) {
  require_probability(probability);
  set_value(cell, rule().clamped(value_of(probability)));
}

void Grid::set_value(const Cell& cell, Value value) {
  if (!within_limits(cell)) refuse_beyond_limits("cell", cell);
  Implementation& grid = *implementation_;
  grid.begin_mutation();
  const Implementation::LeafValues leaf{grid.store->origin_of(cell),
                                        CellMask::single(grid.store->position_of(cell)), &value};
  grid.write({&leaf, 1});
}

void Grid::set_blocks(std::span<const BlockValues> blocks) {
  require_blocks(blocks);
  Implementation& grid = *implementation_;
  grid.begin_mutation();
  // So many leaves at a time at most: memory for them is little beside the map's.
  constexpr std::size_t kMostLeaves = std::size_t{1} << 17;
  std::vector<Implementation::LeafValues> leaves;
  for (const BlockValues& block : blocks) {
    if (block.cells.none()) continue;
    if (leaves.size() + kBlockCells > kMostLeaves) grid.write(std::exchange(leaves, {}));
    const Value* value = block.values.data();
    grid.store->for_each_leaf_of(block.origin, block.cells,
                                 [&](const Cell& origin, const CellMask& cells) {
                                   leaves.push_back({origin, cells, value});
                                   value += cells.count();
                                 });
  }
  grid.write(leaves);
}

void Grid::restore(History history, std::vector<Pose> scan_poses) {
  for (std::size_t i = 0; i < scan_poses.size(); ++i) {
    try {
      check_pose(scan_poses[i]);
    } catch (const Error& error) {
      throw Error(error.kind(), fmt::format("the pose of scan {} is none: {}", i, error.what()));
    }
  }
  implementation_->begin_mutation();
  implementation_->history = history;
  implementation_->scan_poses = std::move(scan_poses);
}

void Grid::repack() { implementation_->store->repack(); }

std::size_t Grid::erase(const Box& box) { return erase_cells(lattice().cells_of(box)); }

std::size_t Grid::erase_cells(const CellBox& cells) {
  implementation_->begin_mutation();
  return implementation_->remove_cells(cells, [](Value) { return true; });
}

std::size_t Grid::prune(double probability) {
  require_probability(probability);
  const Value limit = value_of(probability);
  implementation_->begin_mutation();
  return implementation_->remove_cells(all_cells(), [&](Value value) { return value <= limit; });
}

void Grid::track_flips(std::size_t cells) { implementation_->log.track_flips(cells); }

Changes Grid::changes_since(std::uint64_t since) const {
  const Implementation& grid = *implementation_;
  if (since > revision()) {
    throw Error(ErrorKind::usage,
                fmt::format("revision {} is in the future: the grid is at {}", since, revision()));
  }
  Changes changes{.since = since, .revision = revision()};
  changes.blocks_complete = grid.log.knows_blocks_since(since);
  changes.complete = grid.log.knows_flips_since(since);

  std::vector<Cell> blocks;
  if (changes.blocks_complete) blocks = grid.log.blocks_with_losses_since(since);
  grid.store->visit(all_cells(), [&](LeafId id, const Leaf& leaf) {
    if (!changes.blocks_complete || grid.log.revision_of(grid.store->stamp(id)) > since) {
      blocks.push_back(block_origin(leaf.origin));
    }
    return true;
  });
  sort_unique(blocks);

  for (const Cell& origin : blocks) {
    const CellBox box{.min = origin, .max = origin + Cell::Constant(kBlockEdge)};
    bool exists = false;
    visit_leaves(box, [&](const Leaf& leaf) {
      exists = true;
      if (changes.complete) return false;
      leaf.for_each([&](const Cell& cell, Value value) {
        changes.cells.push_back({cell, rule().occupied(value)});
      });
      return true;
    });
    changes.blocks.push_back({origin, exists});
  }
  if (changes.complete) {
    for (const Cell& cell : grid.log.flipped_since(since)) {
      changes.cells.push_back({cell, cell_state(cell) == State::occupied});
    }
  }
  std::sort(changes.cells.begin(), changes.cells.end(),
            [](const CellState& a, const CellState& b) { return morton_less(a.cell, b.cell); });
  return changes;
}

}  // namespace rmap
