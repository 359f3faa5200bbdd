#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include <rmap/approximate.hpp>
#include <rmap/cuboid_error.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

CuboidError error_by_force(const std::vector<CountedCell>& cells,
                           const std::vector<Cuboid>& cuboids) {
  CuboidError error;
  const auto boxes = test::boxes_of(cuboids);
  const CellSet volume = test::union_of(boxes);
  const CellSet occupied = test::set_of(cells);
  error.cells = cells.size();
  error.cuboids = cuboids.size();
  error.volume = volume.size();
  for (const auto& [cell, points] : cells) {
    error.points += points;
    if (volume.contains(cell)) continue;
    ++error.lost_cells;
    error.lost_points += points;
    std::int64_t nearest = std::int64_t{1} << 40;
    for (const CellBox& box : boxes) nearest = std::min(nearest, test::distance(cell, box));
    if (nearest > 1) ++error.lost_beyond_one;
    if (boxes.empty()) continue;
    error.farthest_lost = std::max(error.farthest_lost, static_cast<std::int32_t>(nearest));
  }
  for (const Cell& cell : volume) {
    if (occupied.contains(cell)) continue;
    ++error.false_cells;
    std::int64_t nearest = std::int64_t{1} << 40;
    for (const Cell& other : occupied) {
      nearest = std::min(nearest, test::distance(other, box_of(cell)));
    }
    if (occupied.empty()) continue;
    error.farthest_false = std::max(error.farthest_false, static_cast<std::int32_t>(nearest));
  }
  return error;
}

void expect_equal(const CuboidError& a, const CuboidError& b) {
  EXPECT_EQ(a.cells, b.cells);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.cuboids, b.cuboids);
  EXPECT_EQ(a.volume, b.volume);
  EXPECT_EQ(a.lost_cells, b.lost_cells);
  EXPECT_EQ(a.lost_points, b.lost_points);
  EXPECT_EQ(a.lost_beyond_one, b.lost_beyond_one);
  EXPECT_EQ(a.false_cells, b.false_cells);
  EXPECT_EQ(a.farthest_false, b.farthest_false);
  EXPECT_EQ(a.farthest_lost, b.farthest_lost);
}

TEST(CuboidError, EqualsLookingAtAllPairs) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 80; ++seed, ++compared) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    std::vector<Cell> cells = test::scattered(random, seed % 20 == 0 ? 0 : 60, 12);
    if (seed % 3 == 0 && !cells.empty()) cells.push_back(random.cell(5000, 9000));  // lost far away
    const auto counted = test::counted(cells, random, 9);
    std::vector<Cuboid> cuboids;
    if (seed % 7 != 0) {
      for (int i = random.integer(1, 10); i > 0; --i)
        cuboids.push_back({random.box(-15, 12, 5), 0});
      if (seed % 4 == 0) cuboids.push_back({random.box(-700, 700, 4), 0});
    }
    expect_equal(cuboid_error(counted, cuboids), error_by_force(counted, cuboids));
    if (HasFailure()) break;
  }
  EXPECT_EQ(compared, 80);
}

TEST(CuboidError, IsNothingWhereNothingDiffers) {
  const CuboidError none = cuboid_error({}, {});
  expect_equal(none, CuboidError{});
  EXPECT_EQ(none.false_share(), 0);
  const CellBox box{.min = {-3, 4, -5}, .max = {9, 8, 7}};
  const auto cells = test::counted(test::solid_box(box));
  const CuboidError exact = cuboid_error(cells, std::vector<Cuboid>{{box, 0}, {box, 0}});
  EXPECT_EQ(exact.volume, cells.size());
  EXPECT_EQ(exact.lost_cells + exact.false_cells, 0u);
  EXPECT_EQ(exact.farthest_false + exact.farthest_lost, 0);
  const CuboidError twice = cuboid_error(cells, std::vector<Cuboid>{{test::grown(box, 2), 0}});
  EXPECT_EQ(twice.farthest_false, 2);
  EXPECT_DOUBLE_EQ(twice.false_share(), 1 - box.volume() / test::grown(box, 2).volume());
}

// The farthest that a cell can be lost, and a union that nobody can look at.
TEST(CuboidError, ReachesFromLimitToLimit) {
  const Cell low = Cell::Constant(kMinCellIndex);
  const Cell high = Cell::Constant(kMaxCellIndex);
  const CuboidError error =
      cuboid_error(std::vector<CountedCell>{{low, 3}}, std::vector<Cuboid>{{box_of(high), 0}});
  EXPECT_EQ(error.lost_points, 3u);
  EXPECT_EQ(error.farthest_lost, kMaxCellIndex - kMinCellIndex);
  EXPECT_EQ(error.farthest_false, kMaxCellIndex - kMinCellIndex);
  try {
    cuboid_error({}, std::vector<Cuboid>{{all_cells(), 0}});
    FAIL() << "it was taken";
  } catch (const Error& refused) {
    EXPECT_EQ(refused.kind(), ErrorKind::limit);
  }
}

/// Bytes of the octree of depth `level` over the cells; `joined`: whether it is one leaf.
std::uint64_t octree(std::vector<Cell> cells, int level, bool prune, bool& joined) {
  joined = level == 0 && !cells.empty();
  if (cells.empty()) return 0;
  if (level == 0) return 16;
  std::vector<Cell> octants[8];
  for (const Cell& cell : cells) {
    const Cell half = cell.unaryExpr([&](std::int32_t index) { return index >> (level - 1) & 1; });
    octants[half.x() | half.y() << 1 | half.z() << 2].push_back(cell);
  }
  std::uint64_t bytes = 80;
  int leaves = 0;
  for (std::vector<Cell>& octant : octants) {
    bool leaf = false;
    bytes += octree(std::move(octant), level - 1, prune, leaf);
    leaves += leaf ? 1 : 0;
  }
  joined = prune && leaves == 8;
  return joined ? 16 : bytes;
}

TEST(CuboidBytes, EqualThoseOfAnOctreeAndOfCounts) {
  int compared = 0;
  Random random(2);
  SCOPED_TRACE(random.trace());
  for (const auto& [name, cells] : test::small_scenes(random)) {
    if (name.ends_with("indices")) continue;  // beyond an octree of depth 16
    SCOPED_TRACE(name);
    const auto counted = test::counted(cells, random, 4);
    const auto cuboids = approximate(counted).cuboids;
    const CuboidBytes bytes = cuboid_bytes(counted, cuboids);
    bool joined = false;
    ASSERT_EQ(bytes.octomap, octree(cells, 16, false, joined));
    ASSERT_EQ(bytes.octomap_pruned, octree(cells, 16, true, joined));
    std::uint64_t points = 0;
    CellSet blocks;
    for (const auto& [cell, count] : counted) {
      points += count;
      blocks.insert(cell.unaryExpr([](std::int32_t index) { return index & ~7; }));
    }
    ASSERT_EQ(bytes.plain, 24 * cuboids.size());
    ASSERT_GE(bytes.packed, 8 * cuboids.size());
    ASSERT_EQ(bytes.raw_points, 12 * points);
    ASSERT_EQ(bytes.voxel_keys, 12 * cells.size());
    ASSERT_EQ(bytes.bit_blocks, 72 * blocks.size());
    ++compared;
  }
  EXPECT_EQ(compared, 13);
  EXPECT_EQ(cuboid_bytes({}, {}).octomap, 0u);
}

}  // namespace
}  // namespace rmap
