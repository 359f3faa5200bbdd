#include "support/plain_grid.hpp"
#include "support/scans.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include <rmap/grid.hpp>

namespace rmap {
namespace {

using test::BeamKind;
using test::PlainGrid;
using test::Random;

// A grid in both layouts, by both traversals, with one and three threads, beside the plain one.
class Twins {
 public:
  explicit Twins(Options options) : plain_(options) {
    for (const Layout layout : {Layout::blocks, Layout::cells}) {
      for (const Traversal traversal : {Traversal::inverse, Traversal::forward}) {
        for (const int threads : {1, 3}) {
          options.layout = layout;
          options.traversal = traversal;
          options.threads = threads;
          options.max_branches = threads == 1 ? 16 : 5;
          grids_.emplace_back(options);
        }
      }
    }
  }

  void prepare(const Scan& scan) {
    plain_.prepare(scan);
    for (Grid& grid : grids_) grid.prepare(scan);
  }

  // Inserts in an order of its own into each.
  InsertReport insert(const Scan& scan, Random& random) {
    const InsertReport expected = plain_.insert(scan);
    for (Grid& grid : grids_) EXPECT_EQ(grid.insert(test::shuffled(scan, random)), expected);
    return expected;
  }

  void expect_equal() const {
    for (const Grid& grid : grids_) {
      EXPECT_EQ(test::difference(grid, plain_), "");
      EXPECT_EQ(grid.check().value_or(""), "");
      EXPECT_TRUE(same_map(grid, grids_.front()));
    }
  }

  const PlainGrid& plain() const { return plain_; }
  const Grid& grid() const { return grids_.front(); }

 private:
  PlainGrid plain_;
  std::vector<Grid> grids_;
};

std::vector<Options> option_sets() {
  return {
      {.resolution = 0.1},
      {.resolution = 0.1, .max_range = 1.5},
      {.resolution = 0.25, .saturation = Saturation::freeze},
      {.resolution = 0.1, .beams = Beams::per_end_cell},
      {.resolution = 0.2,
       .prob_hit = 0.9,
       .prob_miss = 0.2,
       .clamp_min = 0.01,
       .clamp_max = 0.99,
       .prior = 0.3,
       .occupied_threshold = 0.6,
       .min_range = 0.5,
       .max_range = 4},
  };
}

class InsertOptions : public testing::TestWithParam<int> {};

TEST_P(InsertOptions, RandomScansGiveTheMapOfTheDefinition) {
  const Options options = option_sets()[static_cast<std::size_t>(GetParam())];
  Random random(20 + static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(random.trace());
  InsertReport total;
  for (int round = 0; round < 6 && !HasFailure(); ++round) {
    Twins twins(options);
    for (int i = 0; i < 6; ++i) {
      Scan scan = test::random_scan(random, 300, 2.5);
      scan.no_returns = {{1, 0, 0}, {0.3f, -2, 1}, {0, 0, 0}};
      scan.sensor_range = i % 2 == 0 ? 2 : std::numeric_limits<double>::infinity();
      scan.points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0, 0);
      scan.points.emplace_back(3e38f, 0, 0);
      if (round % 2 == 1) twins.prepare(scan);
      total += twins.insert(scan, random);
    }
    twins.expect_equal();
  }
  EXPECT_EQ(total.points, 6u * 6 * 305);
  EXPECT_EQ(total.inserted + total.cut + total.skipped.total(), total.points);
  EXPECT_GT(total.misses, 500u);
}

INSTANTIATE_TEST_SUITE_P(Sets, InsertOptions, testing::Range(0, 5));

class InsertNasty : public testing::TestWithParam<int> {};

TEST_P(InsertNasty, BeamsGiveTheMapOfTheDefinition) {
  const auto kind = static_cast<BeamKind>(GetParam());
  Random random(40 + static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(random.trace());
  int scans = 0;
  InsertReport total;
  for (const double resolution : {1.0, 0.125, 0.1}) {
    Twins twins({.resolution = resolution, .max_range = resolution * 12});
    for (int i = 0; i < 16 && !HasFailure(); ++i) {
      total += twins.insert(
          test::nasty_scan(kind, random, 60, 10, resolution, /*own_origins=*/i % 2 == 1), random);
      ++scans;
    }
    twins.expect_equal();
  }
  EXPECT_EQ(scans, 48);
  if (kind != BeamKind::zero_length) {
    EXPECT_GT(total.misses, 20u);
  }
}

TEST_P(InsertNasty, BeamsNearTheLimitsGiveTheMapOfTheDefinition) {
  const auto kind = static_cast<BeamKind>(GetParam());
  Random random(60 + static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(random.trace());
  // float32 has steps of 128 cells there: beams among a few lattice points, and over the limit.
  const Vector3d center(0x1p30 - 300, -0x1p30 + 300, 0x1p30 - 500);
  Twins twins({.resolution = 1});
  InsertReport total;
  for (int i = 0; i < 10 && !HasFailure(); ++i) {
    Scan scan = test::nasty_scan(kind, random, 40, 200, 1, i % 2 == 1, center);
    total += twins.insert(scan, random);
  }
  twins.expect_equal();
  EXPECT_GT(total.inserted, 0u);
}

INSTANTIATE_TEST_SUITE_P(Kinds, InsertNasty, testing::Range(0, test::kBeamKinds),
                         [](const auto& kind_info) {
                           return test::name_of(static_cast<BeamKind>(kind_info.param));
                         });

// A cell at the edge of the range must be cleared by beams that are cut there:
// where a cut beam does not clear its last cell, it would stay for ever.
TEST(Insert, CutBeamsClearTheCellOfTheCut) {
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    Grid grid({.resolution = 0.1, .layout = layout, .max_range = 5});
    for (int i = 0; i < 5; ++i) grid.insert(test::map_scan({0, 0, 0}, {{4.98f, 0, 0}}));
    const Cell cell = grid.lattice().cell_of({4.98, 0, 0});
    EXPECT_EQ(grid.cell_state(cell), State::occupied);
    for (int i = 0; i < 50; ++i) grid.insert(test::map_scan({0, 0, 0}, {{8, 0, 0}}));
    EXPECT_EQ(grid.cell_state(cell), State::free);
    EXPECT_EQ(grid.cell_count(), 1u);
  }
}

TEST(Insert, ABeamOfExactlyMaxRangeIsAHit) {
  Grid grid({.resolution = 0.5, .max_range = 5});
  const InsertReport report =
      grid.insert(test::map_scan({0, 0, 0}, {{5, 0, 0}, {0, 5.000001f, 0}}));
  EXPECT_EQ(report.inserted, 1u);
  EXPECT_EQ(report.cut, 1u);
}

TEST(Insert, TouchingBeamsChangeNothing) {
  Grid start({.resolution = 1});
  start.insert(test::map_scan({2.5, 2.5, 2.5}, {{2.5f, 2.5f, 2.5f}}));  // the cell (2, 2, 2)
  const Value before = *start.cell_value({2, 2, 2});
  struct Case {
    const char* what;
    Vector3d origin;
    Vector3f end;
    bool crosses;
  };
  for (const Case& example : {
           Case{"passes an edge", {1.5, 2.5, 2.5}, {2.5f, 1.5f, 2.5f}, false},
           Case{"passes a corner", {1.5, 1.5, 3}, {2.5f, 2.5f, 1}, false},
           Case{"ends before the lower face", {0.5, 2.5, 2.5}, {1.999999f, 2.5f, 2.5f}, false},
           Case{"starts in the lower face and leaves", {2, 2.5, 2.5}, {0.5f, 2.5f, 2.5f}, false},
           Case{"ends in the upper face", {5, 2.5, 2.5}, {3, 2.5f, 2.5f}, false},
           Case{"lies in an upper face", {0.5, 3, 2.5}, {6.5f, 3, 2.5f}, false},
           Case{"lies in an upper edge", {0.5, 3, 3}, {6.5f, 3, 3}, false},
           Case{"lies in a lower face", {0.5, 2, 2.5}, {6.5f, 2, 2.5f}, true},
           Case{"lies in a lower edge", {0.5, 2, 2}, {6.5f, 2, 2}, true},
           Case{"passes inside", {0.5, 2.5, 2.5}, {6.5f, 2.5f, 2.5f}, true},
       }) {
    SCOPED_TRACE(example.what);
    Grid grid = start;
    EXPECT_EQ(grid.insert(test::map_scan(example.origin, {example.end})).misses,
              example.crosses ? 1u : 0u);
    EXPECT_EQ(*grid.cell_value({2, 2, 2}), example.crosses ? grid.rule().miss(before) : before);
  }
}

TEST(Insert, OneUpdateACellAndScanAndAHitWins) {
  Grid grid({.resolution = 1});
  // Ten ends in one cell, and beams through it to a farther one.
  std::vector<Vector3f> points(10, Vector3f(3.5f, 0.5f, 0.5f));
  points.insert(points.end(), 10, Vector3f(6.5f, 0.5f, 0.5f));
  const InsertReport report = grid.insert(test::map_scan({0.5, 0.5, 0.5}, points));
  EXPECT_EQ(report.end_cells, 2u);
  EXPECT_EQ(report.hits, 2u);
  EXPECT_EQ(report.misses, 0u);
  EXPECT_EQ(grid.cell_value({3, 0, 0}), grid.rule().hit(grid.rule().prior()));
}

TEST(Insert, ReportsWhatItSkips) {
  Grid grid({.resolution = 0.1, .min_range = 1});
  Scan scan;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  scan.points = {{nan, 0, 0}, {0, infinity, 0}, {0.5f, 0, 0}, {3e38f, 0, 0}, {2, 0, 0}};
  scan.no_returns = {{1, 0, 0}, {0, 0, 0}};
  const InsertReport report = grid.insert(scan);
  EXPECT_EQ(report.points, 7u);
  EXPECT_EQ(report.inserted, 1u);
  EXPECT_EQ(report.skipped,
            (SkippedPoints{.not_finite = 3, .too_near = 1, .beyond_limits = 1, .no_range = 1}));
}

TEST(Insert, RefusesWithTheGridAsItWas) {
  Grid grid({.resolution = 0.1, .bad_points = BadPoints::error});
  grid.insert(test::map_scan({0, 0, 0}, {{1, 0, 0}}));
  const Grid before = grid;
  const auto refused = [&](const Scan& scan, const std::string& part) {
    try {
      grid.insert(scan);
      ADD_FAILURE() << "accepted: " << part;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
    EXPECT_THROW(grid.prepare(scan), Error);
    EXPECT_TRUE(same_map(grid, before));
    EXPECT_EQ(grid.revision(), before.revision());
  };
  refused(test::map_scan({0, 0, 0}, {{1, 1, 1}, {3e38f, 0, 0}}), "beyond the limits");
  refused(test::map_scan({0, 0, 0}, {{1, 1, std::numeric_limits<float>::infinity()}}),
          "not finite");
  refused(test::map_scan({1e12, 0, 0}, {{1, 1, 1}}), "origin");
  refused(test::map_scan({std::nan(""), 0, 0}, {{1, 1, 1}}), "not finite");
  Scan scan = test::map_scan({0, 0, 0}, {{1, 1, 1}});
  scan.origins = {{0, 0, 0}, {0, 0, 0}};
  refused(scan, "2 origins for 1 points");
  scan.origins = {{0, 0, 1e12}};
  refused(scan, "origin");
  scan.origins = {{0, 0, 1}};
  scan.frame = Frame::sensor;
  refused(scan, "origin for each point");
  scan.origins.clear();
  scan.map_from_sensor.linear() *= 2;
  scan.name = "scan 7";
  refused(scan, "scan 7: the 3x3 part of the pose is no rotation");
}

TEST(Insert, TheRTreeIsPackedAsItGrows) {
  test::Random random(31);
  SCOPED_TRACE(random.trace());
  const auto fill = [](const Grid& grid) { return grid.rtree_statistics().levels.at(0).fill; };
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    Grid grid({.resolution = 0.1, .layout = layout});
    grid.insert(test::random_scan(random, 4000, 20));
    EXPECT_GT(fill(grid), 0.95);
    for (int i = 0; i < 4; ++i) grid.prepare(test::random_scan(random, 300, 20));
    EXPECT_EQ(grid.check().value_or(""), "");

    Grid prepared({.resolution = 0.1, .layout = layout});
    const Scan first = test::random_scan(random, 3000, 20);
    prepared.prepare(first);
    prepared.prepare(test::random_scan(random, 1000, 20));
    EXPECT_LT(fill(prepared), 0.9);
    prepared.insert(first);
    EXPECT_GT(fill(prepared), 0.95);
    EXPECT_EQ(prepared.check().value_or(""), "");
  }
}

// Ends may lie in another cell, even another block, than an origin from which they have no
// direction, or one along a single axis: leaves are made once all the same.
TEST(Insert, BeamsTooShortForADirectionHitTheirCells) {
  Random random(86);
  SCOPED_TRACE(random.trace());
  int beside = 0;
  for (int round = 0; round < 60; ++round) {
    Twins twins({.resolution = 1});
    // More leaves around, so that the R-tree has levels.
    std::vector<Vector3f> around;
    for (int i = 0; i < 40; ++i) around.push_back(random.point(-30, 30).cast<float>());
    twins.insert(test::map_scan({3, 3, 3}, around), random);
    const auto tiny = [&] {
      const double size = std::ldexp(1.0, -random.integer(30, 48));
      return random.chance(0.3) ? 0.0 : random.chance(0.5) ? size : -size;
    };
    for (int i = 0; i < 4; ++i) {
      Vector3d corner = 8.0 * random.cell(-1, 1).cast<double>();
      if (random.chance(0.5)) corner[random.integer(0, 2)] += 0.5;
      const Vector3d origin = corner + Vector3d(tiny(), tiny(), tiny());
      // Near zero floats tell such points apart.
      std::vector<Vector3f> ends;
      for (int k = 0; k < 3; ++k) {
        ends.push_back((corner + Vector3d(tiny(), tiny(), tiny())).cast<float>());
        const Vector3d end = ends.back().cast<double>();
        beside += Lattice(1).cell_of(origin) != Lattice(1).cell_of(end) ? 1 : 0;
      }
      const Scan scan = test::map_scan(origin, ends);
      twins.insert(scan, random);
      twins.insert(scan, random);
    }
    twins.expect_equal();
    if (HasFailure()) return;
  }
  EXPECT_GT(beside, 100);
}

}  // namespace
}  // namespace rmap
