// Inverse casting finds what following each beam finds, bit for bit.
#include "support/scans.hpp"
#include "support/simd_targets.hpp"

#include <cmath>
#include <functional>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include <rmap/grid.hpp>

namespace rmap {
namespace {

using test::BeamKind;
using test::Random;

constexpr double kResolution = 0.1;
constexpr double kReach = 12;  // of the filled part of the map, cells

struct ScanKind {
  std::string name;
  std::function<Scan(Random&)> make;
};

// Ends at random ranges along the directions of a sensor at a random pose.
Scan pattern_scan(Random& random, const std::vector<Vector3d>& directions) {
  Scan scan;
  scan.map_from_sensor = test::random_pose(random, 0.6 * kReach * kResolution);
  for (const Vector3d& direction : directions) {
    if (random.chance(0.1)) continue;
    scan.points.push_back((direction * random.real(0.2, 2 * kReach * kResolution)).cast<float>());
  }
  return scan;
}

std::vector<Vector3d> rings(int count, int around) {
  std::vector<Vector3d> directions;
  for (int ring = 0; ring < count; ++ring) {
    const double up = 0.5 * (ring / (count - 1.0) - 0.5);
    for (int i = 0; i < around; ++i) {
      const double at = 2 * std::numbers::pi * i / around;
      directions.emplace_back(std::cos(at) * std::cos(up), std::sin(at) * std::cos(up),
                              std::sin(up));
    }
  }
  return directions;
}

std::vector<Vector3d> pixels(int columns, int rows) {
  std::vector<Vector3d> directions;
  for (int v = 0; v < rows; ++v) {
    for (int u = 0; u < columns; ++u) {
      directions.emplace_back(
          Vector3d(1.2 * u / columns - 0.6, 0.9 * v / rows - 0.45, 1).normalized());
    }
  }
  return directions;
}

std::vector<Vector3d> cone(Random& random, int count) {
  std::vector<Vector3d> directions;
  for (int i = 0; i < count; ++i) {
    directions.push_back((Vector3d(2, 0, 0) + random.direction()).normalized());
  }
  return directions;
}

std::vector<ScanKind> scan_kinds() {
  std::vector<ScanKind> kinds;
  for (int kind = 0; kind < test::kBeamKinds; ++kind) {
    const auto beam_kind = static_cast<BeamKind>(kind);
    for (const bool own_origins : {false, true}) {
      kinds.push_back(
          {test::name_of(beam_kind) + (own_origins ? "_own_origins" : ""), [=](Random& random) {
             // Many short beams from one place hit all that they could miss.
             const std::size_t beams = beam_kind == BeamKind::short_beam && !own_origins ? 3 : 150;
             Scan scan =
                 test::nasty_scan(beam_kind, random, beams, kReach, kResolution, own_origins);
             if (beam_kind != BeamKind::zero_length) return scan;
             // Beams without length clear nothing: some others go with them.
             for (int i = 0; i < 20; ++i) {
               if (own_origins) scan.origins.push_back(scan.origins[0]);
               scan.points.push_back(
                   random.point(-kReach * kResolution, kReach * kResolution).cast<float>());
             }
             return scan;
           }});
    }
  }
  kinds.push_back({"spinning", [](Random& random) { return pattern_scan(random, rings(16, 90)); }});
  kinds.push_back({"one_ring", [](Random& random) { return pattern_scan(random, rings(2, 180)); }});
  kinds.push_back(
      {"depth_camera", [](Random& random) { return pattern_scan(random, pixels(48, 36)); }});
  kinds.push_back(
      {"solid_state", [](Random& random) { return pattern_scan(random, cone(random, 600)); }});
  kinds.push_back({"sonar", [](Random& random) {
                     return pattern_scan(
                         random, {random.direction(), random.direction(), random.direction(),
                                  random.direction(), random.direction(), random.direction()});
                   }});
  kinds.push_back({"one_direction", [](Random& random) {
                     Scan scan =
                         pattern_scan(random, std::vector<Vector3d>(300, random.direction()));
                     return scan;
                   }});
  kinds.push_back({"from_outside", [](Random& random) {
                     const Vector3d origin = 2 * kReach * kResolution * random.direction();
                     std::vector<Vector3f> ends;
                     for (int i = 0; i < 400; ++i) {
                       ends.push_back(Vector3d(random.point(-kReach, kReach) * kResolution -
                                               0.5 * random.real(0, 1) * origin)
                                          .cast<float>());
                     }
                     return test::map_scan(origin, ends);
                   }});
  kinds.push_back({"cut", [](Random& random) {
                     Scan scan = pattern_scan(random, rings(8, 60));
                     for (int i = 0; i < 50; ++i) {
                       scan.no_returns.push_back(random.direction().cast<float>());
                     }
                     scan.sensor_range = random.real(0.2, 2);
                     return scan;
                   }});
  return kinds;
}

// A map with cells in most places around the origin, of all values.
Grid filled_map(Random& random, const Options& options) {
  Grid grid(options);
  for (int i = 0; i < 3; ++i) {
    grid.insert(test::random_scan(random, 700, kReach * kResolution));
  }
  return grid;
}

// One filled map, kept and worked on in several ways.
class FilledMaps {
 public:
  FilledMaps(Random& random, Options options) {
    for (const Layout layout : {Layout::blocks, Layout::cells}) {
      for (const Traversal traversal : {Traversal::forward, Traversal::inverse}) {
        for (const int threads : {1, 2, 3, 8}) {
          options.layout = layout;
          options.traversal = traversal;
          options.threads = threads;
          maps_.push_back(maps_.empty() ? filled_map(random, options) : Grid(options));
          if (maps_.size() > 1) maps_.back().merge(maps_.front());
        }
      }
    }
  }

  std::pair<Grid, InsertReport> after(const Scan& scan, Traversal traversal, Layout layout,
                                      int threads) const {
    for (const Grid& map : maps_) {
      if (map.options().traversal != traversal || map.options().layout != layout ||
          map.options().threads != threads) {
        continue;
      }
      Grid grid = map;
      const InsertReport report = grid.insert(scan);
      return {std::move(grid), report};
    }
    throw std::logic_error("no such map");
  }

 private:
  std::vector<Grid> maps_;
};

TEST(Traversal, InverseFindsWhatForwardFindsOnNastyScans) {
  constexpr int kScansOfAKind = 50;
  const int threads[] = {1, 2, 3, 8};
  Random random(90);
  SCOPED_TRACE(random.trace());
  int scans = 0;
  int comparisons = 0;
  for (const ScanKind& kind : scan_kinds()) {
    SCOPED_TRACE(kind.name);
    const FilledMaps maps(random,
                          {.resolution = kResolution, .max_range = 3 * kReach * kResolution});
    int with_misses = 0;
    for (int tries = 0; with_misses < kScansOfAKind && !HasFailure(); ++tries) {
      ASSERT_LT(tries, 40 * kScansOfAKind) << "scans that miss nothing";
      const Scan scan = kind.make(random);
      const auto result = maps.after(scan, Traversal::forward, Layout::blocks, 1);
      // Named apart: clang 14 lets no lambda capture a structured binding.
      const Grid& reference = result.first;
      const InsertReport& expected = result.second;
      if (expected.misses == 0) continue;
      ++with_misses;
      const Scan mixed = test::shuffled(scan, random);
      test::for_each_simd_target([&](const char* target) {
        SCOPED_TRACE(target);
        const auto [grid, report] = maps.after(mixed, Traversal::inverse, Layout::blocks, 1);
        EXPECT_EQ(report, expected);
        EXPECT_TRUE(same_map(grid, reference));
        ++comparisons;
      });
      for (const Layout layout : {Layout::blocks, Layout::cells}) {
        const auto [grid, report] = maps.after(mixed, Traversal::inverse, layout,
                                               threads[with_misses % std::ssize(threads)]);
        EXPECT_EQ(report, expected);
        EXPECT_TRUE(same_map(grid, reference));
        ++comparisons;
      }
      ++scans;
    }
  }
  EXPECT_EQ(scans, 32 * kScansOfAKind);
  EXPECT_GE(comparisons, 3 * scans);
}

TEST(Traversal, ManyBeamsGiveTheSameMapWithAnyThreads) {
  Random random(91);
  SCOPED_TRACE(random.trace());
  const std::vector<Scan> scans = {test::random_scan(random, 30000, 8),
                                   test::random_scan(random, 30000, 8)};
  Grid reference({.resolution = 0.1, .traversal = Traversal::forward});
  InsertReport expected;
  for (const Scan& scan : scans) expected += reference.insert(scan);
  EXPECT_GT(expected.misses, 1000u);
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    for (const int threads : {1, 2, 3, 8}) {
      Grid grid({.resolution = 0.1, .layout = layout, .threads = threads});
      InsertReport report;
      for (const Scan& scan : scans) report += grid.insert(test::shuffled(scan, random));
      EXPECT_EQ(report, expected);
      EXPECT_TRUE(same_map(grid, reference));
    }
  }
}

TEST(Traversal, MillionsOfBeamsInOneScan) {
  Random random(92);
  SCOPED_TRACE(random.trace());
  const Scan scan = test::random_scan(random, 3'000'000, 4);
  Grid forward({.resolution = 0.2, .traversal = Traversal::forward});
  Grid inverse({.resolution = 0.2, .traversal = Traversal::inverse, .threads = 2});
  for (int i = 0; i < 2; ++i) {
    const InsertReport expected = forward.insert(scan);
    ASSERT_EQ(inverse.insert(scan), expected);
    EXPECT_EQ(expected.points, 3'000'000u);
  }
  EXPECT_TRUE(same_map(inverse, forward));
}

}  // namespace
}  // namespace rmap
