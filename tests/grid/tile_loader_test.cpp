#include "grid/tile_loader.hpp"

#include "support/scans.hpp"
#include "support/simd_targets.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

// Compares a tile with the definition, place by place; returns how many had a beam.
int expect_definition(const PointTile& tile, const ScanBeams& beams, TileDetail detail) {
  int with_beam = 0;
  bool cut_at_origin = false;
  for (std::size_t i = 0; i < tile.count; ++i) {
    SCOPED_TRACE(i);
    const SortedPoint point = beams.sorted(tile.number(i));
    const auto beam = beams.beam(tile.number(i));
    const bool has_direction = beam && beam->direction() != Vector3d::Zero();
    EXPECT_EQ(tile.ends.test(i), point.fate == SortedPoint::Fate::ends);
    EXPECT_EQ(tile.cuts.test(i), point.fate == SortedPoint::Fate::cut);
    EXPECT_EQ(tile.beams.test(i), has_direction && detail != TileDetail::cells);
    cut_at_origin |= beam && beam->cut() && !has_direction;
    if (!beam) continue;
    ++with_beam;
    EXPECT_EQ(tile.cell_of(i), *cell_at(point.end));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      if (detail == TileDetail::cells) continue;
      EXPECT_EQ(tile.direction[axis][i], static_cast<float>(beam->direction()[at]));
      if (detail == TileDetail::directions) continue;
      EXPECT_TRUE(same_bits(tile.end[axis][i], point.end[at]));
    }
  }
  EXPECT_EQ(tile.cut_at_origin, cut_at_origin);
  return with_beam;
}

Scan mixed_scan(Random& random, bool in_map_frame) {
  Scan scan = test::random_scan(random, 700, 5);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  for (const Vector3f& odd : {Vector3f(nan, 0, 0), Vector3f(0, -infinity, 1), Vector3f(3e38F, 0, 0),
                              Vector3f(0, 0, 1e9F), Vector3f(0, 0, 0), Vector3f(1e-30F, 0, 0)}) {
    scan.points.insert(scan.points.begin() + random.integer(0, 600), odd);
  }
  scan.no_returns = {{1, 0, 0}, {0, 0, 0}, {0.1F, -2, 3}};
  scan.sensor_range = 4;
  if (in_map_frame) scan.frame = Frame::map;
  return scan;
}

TEST(TileLoader, LoadsWhatTheDefinitionSays) {
  Random random(70);
  SCOPED_TRACE(random.trace());
  int beams_seen = 0;
  for (int round = 0; round < 12; ++round) {
    const Scan scan = mixed_scan(random, round % 2 == 1);
    const Lattice lattice(round % 3 == 0 ? 0.1 : 0.37);
    Options options{.resolution = lattice.resolution()};
    if (round % 4 >= 2) {
      options.min_range = 0.5;
      options.max_range = 3;
    }
    const ScanBeams beams(scan, lattice, options);
    test::for_each_simd_target([&](const char* target) {
      SCOPED_TRACE(target);
      const auto detail = static_cast<TileDetail>(round / 4);
      TileLoader loader(beams, beams.origin(0), detail);
      PointTile tile;
      std::uint64_t inserted = 0;
      for (std::size_t first = 0; first < beams.size(); first += PointTile::kSize) {
        loader.load(first, std::min(PointTile::kSize, beams.size() - first), tile);
        beams_seen += expect_definition(tile, beams, detail);
        inserted += tile.ends.count();
      }
      EXPECT_EQ(inserted + loader.cut() + loader.skipped().total(), beams.size());

      std::vector<std::uint32_t> some;
      for (std::uint32_t i = 0; i < beams.size(); i += 5) some.push_back(i);
      some.resize(std::min(some.size(), PointTile::kSize));
      loader.load(some, tile);
      beams_seen += expect_definition(tile, beams, detail);
    });
  }
  EXPECT_GT(beams_seen, 12 * 600);
}

TEST(TileMask, KnowsWhatIsMissing) {
  TileMask<128> mask;
  mask.set(3);
  mask.set(64);
  EXPECT_EQ(mask.count(), 2U);
  EXPECT_EQ(mask.missing(66).count(), 64U);
  EXPECT_FALSE(mask.missing(66).test(64));
  EXPECT_TRUE(mask.missing(66).test(65));
  EXPECT_FALSE(mask.missing(66).test(66));
  EXPECT_EQ(mask.missing(0).count(), 0U);
}

}  // namespace
}  // namespace rmap
