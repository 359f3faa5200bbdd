#include "approximation/block_masks.hpp"
#include "approximation/cell_blocks.hpp"

#include <algorithm>

#include <rmap/cuboid_error.hpp>
#include <rmap/cuboid_tree.hpp>
#include <rmap/error.hpp>
#include <rmap/packed_cuboids.hpp>

namespace rmap {

namespace {

constexpr std::int32_t kFarthest = kMaxCellIndex - kMinCellIndex;

/// The cells at most so far from one.
CellBox around(const Cell& cell, std::int32_t distance) {
  constexpr std::int64_t kFirst = kMinCellIndex;
  constexpr std::int64_t kEnd = std::int64_t{kMaxCellIndex} + 1;
  CellBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] =
        static_cast<std::int32_t>(std::max(cell[axis] - std::int64_t{distance}, kFirst));
    box.max[axis] =
        static_cast<std::int32_t>(std::min(cell[axis] + std::int64_t{distance} + 1, kEnd));
  }
  return box;
}

/// The larger of `least` and the distance from a cell to a set of which near(box) tells whether it
/// shares a cell with a box, and which is not empty.
template <class Near>
std::int32_t farther(std::int32_t least, const Cell& cell, const Near& near) {
  if (near(around(cell, least))) return least;
  std::int32_t out = least;     // nothing is so near
  std::int32_t in = least + 1;  // something is, once the loop is done
  while (in < kFarthest && !near(around(cell, in))) {
    out = in;
    in = in < kFarthest / 2 ? 2 * in : kFarthest;
  }
  while (out + 1 < in) {
    const std::int32_t middle = out + (in - out) / 2;
    (near(around(cell, middle)) ? in : out) = middle;
  }
  return in;
}

void check_volume(std::span<const Cuboid> cuboids) {
  double volume = 0;
  for (const Cuboid& cuboid : cuboids) volume += cuboid.cells.volume();
  constexpr double kMost = 1LL << 31;
  if (volume >= kMost) {
    throw Error(ErrorKind::limit, "the cuboids hold 2^31 cells or more: too many to look at each");
  }
}

void measure_lost(const CellBlocks& cells, const BlockMasks& volume,
                  std::span<const Cuboid> cuboids, CuboidError& error) {
  const RTree<std::uint32_t> tree = cuboid_tree(cuboids);
  const auto near = [&](const CellBox& box) {
    return !tree.overlapping(box, [](const CellBox&, std::uint32_t) { return false; });
  };
  cells.for_each(cells.bounds(), [&](const Cell& cell, std::size_t number) {
    if (volume.contains(cell)) return;
    ++error.lost_cells;
    error.lost_points += cells.points(number);
    if (cuboids.empty()) return;
    if (!near(around(cell, 1))) ++error.lost_beyond_one;
    error.farthest_lost = farther(error.farthest_lost, cell, near);
  });
  if (cuboids.empty()) error.lost_beyond_one = error.lost_cells;
}

void measure_false(const CellBlocks& cells, const BlockMasks& volume, CuboidError& error) {
  const auto near = [&](const CellBox& box) { return cells.overlaps(box); };
  volume.for_each_block([&](const Cell& origin, const CellMask& inside) {
    const CellBlocks::Block* block = cells.find(origin);
    const CellMask empty = block == nullptr ? inside : inside.without(block->cells);
    error.false_cells += empty.count();
    if (cells.size() == 0) return;
    empty.for_each([&](BlockPosition position) {
      error.farthest_false = farther(error.farthest_false, origin + block_offset(position), near);
    });
  });
}

constexpr std::uint64_t kLeafBytes = 16;
constexpr std::uint64_t kInnerBytes = 80;
constexpr int kOctomapDepth = 16;

Cell parent_of(const Cell& node) {
  return node.unaryExpr([](std::int32_t index) { return index >> 1; });
}

void sort_unique(std::vector<Cell>& nodes) {
  std::sort(nodes.begin(), nodes.end(), morton_less);
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
}

/// Bytes of an octree of OctoMap's depth with these nodes as its only leaves.
std::uint64_t octree_bytes(std::vector<Cell> nodes) {
  std::uint64_t bytes = kLeafBytes * nodes.size();
  for (int level = 0; level < kOctomapDepth; ++level) {
    for (Cell& node : nodes) node = parent_of(node);
    sort_unique(nodes);
    bytes += kInnerBytes * nodes.size();
  }
  return bytes;
}

/// The same with eight leaves that have one parent joined to one, level by level.
std::uint64_t pruned_octree_bytes(std::vector<Cell> full) {
  std::uint64_t bytes = 0;
  std::vector<Cell> inner;
  for (int level = 0; level < kOctomapDepth; ++level) {
    std::vector<Cell> full_parents;
    for (Cell& node : inner) node = parent_of(node);
    for (std::size_t i = 0, end = 0; i < full.size(); i = end) {
      const Cell parent = parent_of(full[i]);
      while (end < full.size() && parent_of(full[end]) == parent) ++end;
      if (end - i == 8) {
        full_parents.push_back(parent);
      } else {
        bytes += kLeafBytes * (end - i);
        inner.push_back(parent);
      }
    }
    sort_unique(inner);
    bytes += kInnerBytes * inner.size();
    full.swap(full_parents);
  }
  return bytes + kLeafBytes * full.size();
}

}  // namespace

CuboidError cuboid_error(std::span<const CountedCell> input, std::span<const Cuboid> cuboids) {
  check_volume(cuboids);
  const CellBlocks cells(input);
  BlockMasks volume;
  for (const Cuboid& cuboid : cuboids) volume.add(cuboid.cells);
  CuboidError error;
  error.cells = cells.size();
  for (std::size_t i = 0; i < cells.size(); ++i) error.points += cells.points(i);
  error.cuboids = cuboids.size();
  error.volume = static_cast<std::uint64_t>(volume.size());
  measure_lost(cells, volume, cuboids, error);
  measure_false(cells, volume, error);
  return error;
}

CuboidBytes cuboid_bytes(std::span<const CountedCell> input, std::span<const Cuboid> cuboids) {
  const CellBlocks cells(input);
  CuboidBytes bytes;
  bytes.plain = 24 * cuboids.size();
  for (const CuboidChunk& chunk : pack(cuboids)) bytes.packed += 8 * chunk.cuboids.size();
  for (std::size_t i = 0; i < cells.size(); ++i) bytes.raw_points += 12ULL * cells.points(i);
  bytes.voxel_keys = 12 * cells.size();
  bytes.bit_blocks = 72 * cells.blocks().size();
  std::vector<Cell> leaves;
  // As keys of OctoMap, so that cells on both sides of 0 have one root.
  const Cell key_of_zero = Cell::Constant(1 << (kOctomapDepth - 1));
  for (const CountedCell& counted : input) leaves.push_back(counted.cell + key_of_zero);
  sort_unique(leaves);
  bytes.octomap = octree_bytes(leaves);
  bytes.octomap_pruned = pruned_octree_bytes(std::move(leaves));
  return bytes;
}

}  // namespace rmap
