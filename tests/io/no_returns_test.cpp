#include "io/no_returns.hpp"

#include "io/files.hpp"

#include <gtest/gtest.h>

#include <rmap/grid.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::write_text;

TEST(NoReturns, are_points_at_that_range) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "a.xyz";
  write_text(file, "13 5 0\n12.99 5 0\n1 13 0\nnan 0 0\n");
  const auto source = open_scans(file, {.sensor_origin = Vector3d(1, 0, 0), .no_return = 13});
  Scan scan;
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.points.size(), 2u);
  EXPECT_EQ(scan.no_returns, (std::vector<Vector3f>{{12, 5, 0}, {0, 13, 0}}));
  EXPECT_EQ(scan.sensor_range, 13);
  Grid grid({.resolution = 1});
  const InsertReport report = grid.insert(scan);
  EXPECT_EQ(report.cut, 2u);
  EXPECT_EQ(report.hits, 1u);
}

TEST(NoReturns, need_one_place_of_the_sensor_and_a_range) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "a.csv";
  write_text(file, "x,y,z,ox,oy,oz\n1,2,3,0,0,0\n");
  const auto source = open_scans(file, {.no_return = 5});
  Scan scan;
  EXPECT_THROW(source->next(scan), Error);
  for (const double range : {0.0, -1.0, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(open_scans(file, {.no_return = range}), Error) << range;
  }
}

}  // namespace
}  // namespace rmap
