#include "evaluation/seen_cells.hpp"

#include "support/random.hpp"
#include "support/scans.hpp"

#include <gtest/gtest.h>

#include <rmap/beam.hpp>

namespace rmap::evaluation {
namespace {

// Whether each point has an origin of its own.
class SeenCellsOf : public testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Origins, SeenCellsOf, testing::Bool());

TEST_P(SeenCellsOf, AreThoseThatBeamsEndInAndCross) {
  test::Random random(3);
  SCOPED_TRACE(random.trace());
  const Lattice lattice(0.5);
  std::vector<Vector3f> points;
  for (int i = 0; i < 40; ++i) points.push_back(random.point(-3, 3).cast<float>());
  Scan scan = test::map_scan({0.1, 0.2, 0.3}, points);
  if (GetParam()) {
    for (std::size_t i = 0; i < points.size(); ++i) scan.origins.push_back(random.point(-3, 3));
  }
  const SeenCells seen = seen_cells(scan, lattice);

  std::size_t ends = 0;
  std::size_t path = 0;
  for (int z = -7; z < 7; ++z) {
    for (int y = -7; y < 7; ++y) {
      for (int x = -7; x < 7; ++x) {
        const Cell cell(x, y, z);
        bool is_end = false;
        bool is_crossed = false;
        for (std::size_t i = 0; i < points.size(); ++i) {
          const Vector3d origin = GetParam() ? scan.origins[i] : Vector3d(0.1, 0.2, 0.3);
          const Vector3d end = lattice.to_cells(points[i].cast<double>());
          is_end = is_end || cell_at(end) == cell;
          is_crossed = is_crossed || crosses(Beam(lattice.to_cells(origin), end, false), cell);
        }
        EXPECT_EQ(seen.ends.contains(cell), is_end);
        EXPECT_EQ(seen.path.contains(cell), is_crossed && !is_end);
        ends += is_end ? 1 : 0;
        path += is_crossed && !is_end ? 1 : 0;
      }
    }
  }
  EXPECT_GT(ends, 20u);
  EXPECT_EQ(seen.ends.size(), ends);
  EXPECT_EQ(seen.path.size(), path);
}

}  // namespace
}  // namespace rmap::evaluation
