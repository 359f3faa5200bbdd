#include "approximation/plain_cells.hpp"
#include "support/random.hpp"

#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include <rmap/packed_cuboids.hpp>

namespace rmap {
namespace {

using test::Random;

TEST(PackedCuboids, HoldTheSameCells) {
  int compared = 0;
  int cut = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed, ++compared) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    std::vector<Cuboid> cuboids;
    for (int i = random.integer(1, 12); i > 0; --i) {
      CellBox box = random.box(-700, 700, 6);
      if (random.chance(0.5)) {
        const int axis = random.integer(0, 2);
        box.max[axis] = box.min[axis] + random.integer(250, 1100);
      }
      cuboids.push_back({box, 7});
    }
    const auto chunks = pack(cuboids);
    std::set<std::tuple<int, int, int>> origins;
    for (const CuboidChunk& chunk : chunks) {
      ASSERT_FALSE(chunk.cuboids.empty());
      for (int axis = 0; axis < 3; ++axis) ASSERT_EQ(chunk.origin[axis] & 255, 0);
      ASSERT_TRUE(origins.insert({chunk.origin.x(), chunk.origin.y(), chunk.origin.z()}).second);
    }
    const auto unpacked = unpack(chunks);
    for (const Cuboid& cuboid : unpacked) {
      ASSERT_FALSE(cuboid.cells.empty());
      ASSERT_LE(cuboid.cells.extent().maxCoeff(), 256);
    }
    ASSERT_EQ(test::union_of(test::boxes_of(unpacked)), test::union_of(test::boxes_of(cuboids)));
    cut += unpacked.size() > cuboids.size() ? 1 : 0;
  }
  EXPECT_EQ(compared, 60);
  EXPECT_GT(cut, 20);
}

TEST(PackedCuboids, KeepTheOrderOfAChunk) {
  const std::vector<Cuboid> cuboids{{{{-1, -1, -1}, {1, 1, 1}}, 0},
                                    {{{3, 4, 5}, {259, 5, 6}}, 0},
                                    {{{-256, -256, -256}, {-255, -255, 0}}, 0},
                                    {{{0, 0, 0}, {1, 1, 1}}, 0}};
  const auto chunks = pack(cuboids);
  ASSERT_EQ(chunks.size(), 2u);
  EXPECT_EQ(chunks[0].origin, Cell::Constant(-256));
  EXPECT_EQ(chunks[1].origin, Cell::Zero());
  EXPECT_EQ(chunks[0].cuboids, (std::vector<PackedCuboid>{{{255, 255, 255}, {1, 1, 1}, 0},
                                                          {{0, 0, 0}, {0, 0, 255}, 0}}));
  EXPECT_EQ(unpack(chunks), (std::vector{cuboids[0], cuboids[2], cuboids[1], cuboids[3]}));
  EXPECT_TRUE(pack({}).empty());
  EXPECT_TRUE(unpack({}).empty());
}

TEST(PackedCuboids, ReachToTheLimits) {
  const CellBox lowest{.min = Cell::Constant(kMinCellIndex),
                       .max = Cell::Constant(kMinCellIndex + 2)};
  const CellBox highest{.min = Cell::Constant(kMaxCellIndex - 300),
                        .max = Cell::Constant(kMaxCellIndex + 1)};
  const auto unpacked = unpack(pack(std::vector<Cuboid>{{lowest, 0}, {highest, 0}}));
  ASSERT_EQ(unpacked.size(), 1u + 8u);
  EXPECT_EQ(unpacked[0].cells, lowest);
  double volume = 0;
  for (std::size_t i = 1; i < unpacked.size(); ++i) {
    EXPECT_TRUE(highest.contains(unpacked[i].cells));
    volume += unpacked[i].cells.volume();
  }
  EXPECT_EQ(volume, highest.volume());
}

}  // namespace
}  // namespace rmap
