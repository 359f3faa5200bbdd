// Files that others wrote, as they are.
#include "io/files.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

struct Sequence {
  std::string name;
  std::size_t scans;
  std::size_t least_points;  // of a scan
  std::size_t most_points;
  double max_range;  // metres
};

std::size_t finite(const std::vector<Vector3f>& points) {
  return static_cast<std::size_t>(std::count_if(
      points.begin(), points.end(), [](const Vector3f& point) { return point.allFinite(); }));
}

void expect_sound(const Sequence& sequence, const std::filesystem::path& folder) {
  SCOPED_TRACE(sequence.name);
  std::size_t least = sequence.most_points;
  std::size_t most = 0;
  std::size_t scans = 0;
  float range = 0;
  ScanRange range_of_scans = read_scans(folder);
  EXPECT_EQ(range_of_scans.size(), sequence.scans);
  for (const Scan& scan : range_of_scans) {
    ++scans;
    least = std::min(least, scan.points.size());
    most = std::max(most, scan.points.size());
    EXPECT_EQ(finite(scan.points), scan.points.size());
    for (const Vector3f& point : scan.points) range = std::max(range, point.norm());
  }
  EXPECT_EQ(scans, sequence.scans);
  EXPECT_EQ(least, sequence.least_points);
  EXPECT_EQ(most, sequence.most_points);
  EXPECT_NEAR(range, sequence.max_range, 0.06);
  EXPECT_EQ(read_poses(folder / "poses.txt").size(), sequence.scans);
}

TEST(RealData, sequences_have_a_pose_for_each_scan) {
  const auto folder = test::real_data("sequences");
  if (folder.empty()) GTEST_SKIP() << "the real data are missing: RMAP_DATA names their folder";
  const std::vector<Sequence> sequences = {{"street_kitti", 10, 121173, 123996, 80.0},
                                           {"hall_lidar", 9, 79254, 90252, 55.4},
                                           {"stationary_outdoor", 5, 41282, 41400, 195.0},
                                           {"livingroom_depth", 5, 52001, 55750, 9.76},
                                           {"kitchen_depth", 5, 67784, 70249, 3.79},
                                           {"corridor_tilt", 3, 77583, 77831, 32.4},
                                           {"corridor_2d", 120, 292, 360, 12.0}};
  for (const Sequence& sequence : sequences) expect_sound(sequence, folder / sequence.name);
  EXPECT_EQ(sequences.size(), 7u);
}

struct Cloud {
  std::string name;
  std::size_t points;
  std::size_t finite;
};

TEST(RealData, clouds_have_their_points) {
  const auto folder = test::real_data("clouds");
  if (folder.empty()) GTEST_SKIP() << "the real data are missing: RMAP_DATA names their folder";
  const std::vector<Cloud> clouds = {{"office1_viewpoint.pcd", std::size_t{640} * 480, 254456},
                                     {"bun0_ascii.pcd", 397, 397},
                                     {"city_samp12_utm.pcd", 52119, 52119},
                                     {"bunny.ply", 35947, 35947},
                                     {"bunny_vertices_be.ply", 35947, 35947},
                                     {"street_target_le.ply", 69088, 69088},
                                     {"autzen_thin.las", 10653, 10653},
                                     {"autzen_utm.las", 1065, 1065},
                                     {"autzen_las12_color.las", 1065, 1065},
                                     {"las14_pdrf6.las", 1000, 1000},
                                     {"car_cloud400.csv", 24989, 24989},
                                     {"points_cloudcompare.xyz", 101, 101},
                                     {"tdtk/scan001.3d", 81360, 81360},
                                     {"../maps/scan.dat", 88206, 88206}};
  for (const Cloud& cloud : clouds) {
    const auto points = read_points(folder / cloud.name);
    EXPECT_EQ(points.size(), cloud.points) << cloud.name;
    EXPECT_EQ(finite(points), cloud.finite) << cloud.name;
  }
  EXPECT_EQ(read_points(folder / "bun0_ascii.pcd").at(0),
            Vector3f(0.0054215998F, 0.11349F, 0.040748999F));
  // An office, seen from within: no column was taken for another.
  Vector3f low = Vector3f::Constant(1e9F);
  Vector3f high = -low;
  for (const Vector3f& point : read_points(folder / "office1_viewpoint.pcd")) {
    if (!point.allFinite()) continue;
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  EXPECT_GT(low.z(), 0.3F);
  EXPECT_LT(high.z(), 12.0F);
  EXPECT_LT(low.x(), 0.0F);
  EXPECT_GT(high.x(), 0.0F);
}

TEST(RealData, one_bunny_is_the_other) {
  const auto folder = test::real_data("clouds");
  if (folder.empty()) GTEST_SKIP() << "the real data are missing: RMAP_DATA names their folder";
  EXPECT_TRUE(test::same_bits(read_points(folder / "bunny.ply"),
                              read_points(folder / "bunny_vertices_be.ply")));
}

// The header of a LAS file names the box of its points.
TEST(RealData, las_points_fill_the_box_of_their_header) {
  const auto folder = test::real_data("clouds");
  if (folder.empty()) GTEST_SKIP() << "the real data are missing: RMAP_DATA names their folder";
  const Vector3d low(493994.87, 4877429.62, 123.93);
  const Vector3d high(494993.68, 4878817.02, 178.73);
  const Vector3d offset(494000, 4878000, 0);
  Vector3d least = high;
  Vector3d most = low;
  for (const Vector3f& point : read_points(folder / "autzen_utm.las", {.offset = offset})) {
    least = least.cwiseMin(point.cast<double>() + offset);
    most = most.cwiseMax(point.cast<double>() + offset);
  }
  EXPECT_LT((least - low).norm(), 1e-4);
  EXPECT_LT((most - high).norm(), 1e-4);
}

// Another program turned the same scan to the right-handed form, refined its pose and left out
// returns that are none.
TEST(RealData, scans_of_3dtk_are_turned_as_others_turn_them) {
  const auto file = test::real_data("clouds/tdtk/scan001.3d");
  const auto other = test::real_data("sequences/corridor_tilt");
  if (file.empty() || other.empty()) {
    GTEST_SKIP() << "the real data are missing: RMAP_DATA names their folder";
  }
  Scan ours;
  ASSERT_TRUE(open_scans(file)->next(ours));
  Scan theirs;
  ASSERT_TRUE(open_scans(other / "000001.bin")->next(theirs));
  EXPECT_LT((ours.map_from_sensor.translation() - theirs.map_from_sensor.translation()).norm(),
            0.05);
  EXPECT_LT((ours.map_from_sensor.linear() - theirs.map_from_sensor.linear()).norm(), 0.01);
  // In the order of the file, some left out.
  std::size_t found = 0;
  auto place = ours.points.begin();
  for (const Vector3f& point : theirs.points) {
    const auto match = std::find_if(place, ours.points.end(), [&](const Vector3f& candidate) {
      return (candidate - point).norm() < 1e-5F * point.norm();
    });
    if (match == ours.points.end()) continue;
    place = match + 1;
    ++found;
  }
  EXPECT_GT(found, theirs.points.size() * 99 / 100);
}

TEST(RealData, a_scan_graph_is_read_whole) {
  const auto file = test::real_data("maps/spherical_scan.graph");
  if (file.empty()) GTEST_SKIP() << "the real data are missing: RMAP_DATA names their folder";
  const auto source = open_scans(file);
  Scan scan;
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.points.size(), 10201u);
  EXPECT_FALSE(source->next(scan));
}

}  // namespace
}  // namespace rmap
