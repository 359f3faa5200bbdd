#include "grid/inverse/beam_index.hpp"

#include "grid/end_cells.hpp"
#include "support/scans.hpp"
#include "support/simd_targets.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::BeamKind;
using test::Random;

// The beams of a scan from one origin, plain and indexed.
struct Indexed {
  Indexed(const Scan& scan, const Options& with)
      : options(with),
        lattice(options.resolution),
        beams(scan, lattice, options),
        group(groups_by_origin(beams).front()),
        index(index_for(beams, group)) {
    index_beams(beams, group, index);
    index.sort(options.threads);
  }

  Options options;
  Lattice lattice;
  ScanBeams beams;
  BeamGroup group;
  BeamIndex index;
};

TEST(BeamIndex, ReachesEveryBoxThatABeamCrosses) {
  Random random(72);
  SCOPED_TRACE(random.trace());
  int crossed = 0;
  int culled = 0;
  for (int kind = 0; kind < test::kBeamKinds; ++kind) {
    SCOPED_TRACE(test::name_of(static_cast<BeamKind>(kind)));
    for (int round = 0; round < 20; ++round) {
      const Options options{.resolution = 1, .threads = 1 + round % 3};
      const Scan scan = test::nasty_scan(static_cast<BeamKind>(kind), random, 40, 12, 1, false);
      const Indexed indexed(scan, options);
      for (int i = 0; i < 100; ++i) {
        const CellBox box = random.box(-16, 16, i % 2 == 0 ? 1 : 9);
        bool is_crossed = false;
        for (std::size_t b = 0; b < indexed.beams.size(); ++b) {
          is_crossed |= crossing(*indexed.beams.beam(b), box).has_value();
        }
        const bool reached = indexed.index.may_reach(box);
        EXPECT_TRUE(reached || !is_crossed);
        crossed += is_crossed ? 1 : 0;
        culled += reached ? 0 : 1;
      }
    }
  }
  EXPECT_GT(crossed, 1000);
  EXPECT_GT(culled, 1000);
}

TEST(BeamIndex, HoldsEachBeamOnceInTheBinOfItsDirection) {
  Random random(73);
  SCOPED_TRACE(random.trace());
  for (const int threads : {1, 3}) {
    const Scan scan = test::random_scan(random, 6000, 10);
    test::for_each_simd_target([&](const char* target) {
      SCOPED_TRACE(target);
      const Indexed indexed(scan, {.resolution = 0.1, .threads = threads});
      const IndexedBeams& sorted = indexed.index.beams();
      std::vector<int> seen(scan.points.size(), 0);
      const int rows = cube_map::kFaces * sorted.bins;
      for (int row = 0; row < rows; ++row) {
        const cube_map::Axes axes = cube_map::axes_of(row / sorted.bins);
        const std::int32_t* borders = sorted.borders + sorted.row_borders[row];
        for (int u = 0; u < sorted.bins; ++u) {
          for (std::int32_t i = borders[u]; i < borders[u + 1]; ++i) {
            ++seen[sorted.number[i]];
            const Vector3d direction = indexed.beams.beam(sorted.number[i])->direction();
            const double depth = std::abs(direction[static_cast<Eigen::Index>(axes.depth)]);
            EXPECT_GE(depth * (1 + 1e-6), direction.cwiseAbs().maxCoeff());
            const auto bin = [&](std::size_t axis) {
              return (direction[static_cast<Eigen::Index>(axis)] / depth + 1) / 2 * sorted.bins;
            };
            EXPECT_NEAR(bin(axes.u), u + 0.5, 0.501);
            EXPECT_NEAR(bin(axes.v), row % sorted.bins + 0.5, 0.501);
          }
        }
      }
      EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ssize(seen));
    });
  }
}

TEST(BeamIndex, NotesCutBeamsWithoutDirection) {
  Scan scan = test::map_scan({0.5, 0.5, 0.5}, {{0.5F, 0.5F, 0.5F}});
  EXPECT_FALSE(Indexed(scan, {.resolution = 1}).index.has_cut_at_origin());
  scan.no_returns = {{1, 0, 0}};
  scan.sensor_range = 0;
  const Indexed indexed(scan, {.resolution = 1});
  EXPECT_TRUE(indexed.index.has_cut_at_origin());
  EXPECT_FALSE(indexed.index.may_reach(box_of({0, 0, 0})));
}

}  // namespace
}  // namespace rmap
