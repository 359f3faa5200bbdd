#include "support/random.hpp"
#include "support/scans.hpp"

#include <limits>

#include <gtest/gtest.h>

#include <rmap/scan_filter.hpp>

namespace rmap {
namespace {

using test::Random;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(ScanFilter, TakesOutWhatIsIgnoredOrOutsideTheCrop) {
  Random random(83);
  SCOPED_TRACE(random.trace());
  const ScanFilter filter{
      .ignore = {{.min = {-1, -1, -1}, .max = {1, 1, 1}}, {.min = {2, -3, -3}, .max = {3, 3, 3}}},
      .crop = Box{.min = {-4, -3, -2}, .max = {4, 5, 6}}};
  ScanFilter::Counts counts;
  ScanFilter::Counts expected;
  std::size_t kept = 0;
  for (int round = 0; round < 20; ++round) {
    Scan scan{.map_from_sensor = test::random_pose(random, 2)};
    for (int i = 0; i < 100; ++i) scan.points.push_back(random.point(-5, 5).cast<float>());
    scan.points[7].x() = kNan;
    std::vector<Vector3f> wanted;
    for (const Vector3f& point : scan.points) {
      const Vector3d in_sensor = point.cast<double>();
      if (filter.ignore[0].contains(in_sensor) || filter.ignore[1].contains(in_sensor)) {
        ++expected.ignored;
      } else if (point.allFinite() &&
                 !filter.crop->contains(transformed(scan.map_from_sensor, point))) {
        ++expected.cropped;
      } else {
        wanted.push_back(point);
      }
    }
    filter.apply(scan, counts);
    ASSERT_EQ(scan.points.size(), wanted.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      ASSERT_TRUE(scan.points[i] == wanted[i] || !wanted[i].allFinite());
    }
    kept += wanted.size();
  }
  EXPECT_EQ(counts.ignored, expected.ignored);
  EXPECT_EQ(counts.cropped, expected.cropped);
  EXPECT_GT(counts.ignored, 50u);
  EXPECT_GT(counts.cropped, 50u);
  EXPECT_GT(kept, 50u);
}

TEST(ScanFilter, KnowsBothFramesAndKeepsOriginsInStep) {
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(10, 0, 0);
  Scan scan{.map_from_sensor = pose,
            .frame = Frame::map,
            .points = {{10.5F, 0, 0}, {0.5F, 0, 0}, {30, 0, 0}},
            .origins = {{1, 1, 1}, {2, 2, 2}, {3, 3, 3}},
            .no_returns = {{1, 0, 0}}};
  const ScanFilter filter{.ignore = {{.min = {0, -1, -1}, .max = {1, 1, 1}}},
                          .crop = Box{.min = {-20, -1, -1}, .max = {20, 1, 1}}};
  ScanFilter::Counts counts;
  filter.apply(scan, counts);
  EXPECT_EQ(scan.points, (std::vector<Vector3f>{{0.5F, 0, 0}}));
  EXPECT_EQ(scan.origins, (std::vector<Vector3d>{{2, 2, 2}}));
  EXPECT_EQ(scan.no_returns.size(), 1u);
  EXPECT_EQ(counts.ignored, 1u);
  EXPECT_EQ(counts.cropped, 1u);
}

TEST(ScanFilter, WithoutBoxesLeavesAScanAsItIs) {
  Scan scan{.points = {{1, 2, 3}, {kNan, 0, 0}}};
  ScanFilter::Counts counts;
  ScanFilter{}.apply(scan, counts);
  EXPECT_EQ(scan.points.size(), 2u);
  EXPECT_EQ(counts.ignored + counts.cropped, 0u);
}

}  // namespace
}  // namespace rmap
