#include "io/scan_file.hpp"

#include "io/files.hpp"

#include <gtest/gtest.h>

#include <rmap/grid.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::write_text;

Scan only_scan(const std::filesystem::path& file, const ScanReadOptions& options) {
  const auto source = open_scans(file, options);
  Scan scan;
  EXPECT_TRUE(source->next(scan));
  Scan none;
  EXPECT_FALSE(source->next(none));
  return scan;
}

TEST(ScanFile, says_what_a_lone_cloud_needs) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.xyz";
  const std::string sentence =
      file +
      " does not say where its beams began: give the place of the sensor (--sensor-origin "
      "X,Y,Z, for points in the map's frame) or its pose (--sensor-pose "
      "X,Y,Z,QX,QY,QZ,QW, for points in the sensor's), or take its points as ends alone "
      "(--end-points)";
  write_text(file, "1 2 3\n");
  expect_error(ErrorKind::input, sentence, [&] { open_scans(file); });
  write_text(file, "1 2 5648349.8\n");
  expect_error(ErrorKind::input,
               sentence +
                   ". Its coordinates are beyond 1e5, where float32 loses digits: an offset "
                   "near them (--offset X,Y,Z) keeps them",
               [&] { open_scans(file); });
}

TEST(ScanFile, skips_points_whose_beams_began_nowhere) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "a.csv";
  write_text(file, "x,y,z,ox,oy,oz\n1,2,3,0,0,0\n4,5,6,nan,0,0\n7,8,9,0,inf,0\n");
  Grid grid({.resolution = 0.5});
  const InsertReport report = grid.insert(only_scan(file, {}));
  EXPECT_EQ(report.inserted, 1u);
  EXPECT_EQ(report.skipped.not_finite, 2u);
}

TEST(ScanFile, takes_an_origin_a_pose_or_ends_alone) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "a.xyz";
  write_text(file, "1001 2 3\nnan 0 0\n");
  const Vector3d offset(1000, 0, 0);

  const Scan from_origin =
      only_scan(file, {.sensor_origin = Vector3d(1005, 6, 7), .offset = offset});
  EXPECT_EQ(from_origin.frame, Frame::map);
  EXPECT_EQ(from_origin.map_from_sensor.translation(), Vector3d(5, 6, 7));
  EXPECT_EQ(from_origin.points.at(0), Vector3f(1, 2, 3));

  const Pose pose = make_pose({1005, 6, 7}, Eigen::Quaterniond(0, 0, 0, 1));
  const Scan from_pose = only_scan(file, {.sensor_pose = pose, .offset = offset});
  EXPECT_EQ(from_pose.frame, Frame::sensor);
  EXPECT_EQ(from_pose.map_from_sensor.translation(), Vector3d(5, 6, 7));
  EXPECT_EQ(from_pose.points.at(0), Vector3f(1001, 2, 3));
  const Scan in_world =
      only_scan(file, {.frame = Frame::map, .sensor_pose = pose, .offset = offset});
  EXPECT_EQ(in_world.frame, Frame::map);
  EXPECT_EQ(in_world.points.at(0), Vector3f(1, 2, 3));

  const Scan ends = only_scan(file, {.end_points = true, .offset = offset});
  EXPECT_EQ(ends.frame, Frame::map);
  ASSERT_EQ(ends.origins.size(), 2u);
  EXPECT_EQ(ends.origins.at(0), Vector3d(1, 2, 3));
  Grid grid({.resolution = 0.5});
  const InsertReport report = grid.insert(ends);
  EXPECT_EQ(report.hits, 1u);
  EXPECT_EQ(report.misses, 0u);
  EXPECT_EQ(report.skipped.not_finite, 1u);
  EXPECT_EQ(grid.state({1.1, 2.1, 3.1}), State::occupied);
}

TEST(ScanFile, takes_the_viewpoint_of_a_pcd_where_it_means_something) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "a.pcd";
  const auto with_viewpoint = [](const std::string& viewpoint) {
    return "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\nVIEWPOINT " + viewpoint +
           "\nDATA ascii\n1 2 3\n";
  };
  write_text(file, with_viewpoint("0 0 0 1 0 0 0"));
  EXPECT_THROW(open_scans(file), Error);
  write_text(file, with_viewpoint("5 6 7 0 1 0 0"));
  const Scan scan = only_scan(file, {});
  EXPECT_EQ(scan.frame, Frame::sensor);
  EXPECT_TRUE(transformed(scan.map_from_sensor, scan.points.at(0)).isApprox(Vector3d(6, 4, 4)));
  for (const std::string broken : {"0 0 0 0 0 0 0", "1 2 3", "0 0 0 1 0 0 0 0", "a 0 0 1 0 0 0"}) {
    write_text(file, with_viewpoint(broken));
    EXPECT_THROW(open_scans(file), Error) << broken;
  }
}

TEST(ScanFile, refuses_options_that_contradict_one_another) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.xyz";
  write_text(file, "1 2 3\n");
  const ScanReadOptions both{.sensor_pose = Pose::Identity(), .end_points = true};
  expect_error(ErrorKind::usage,
               file +
                   ": a sensor pose, a sensor origin and end points exclude one another: each "
                   "says where its beams began",
               [&] { open_scans(file, both); });
  const ScanReadOptions origin{.frame = Frame::sensor, .sensor_origin = Vector3d::Zero()};
  EXPECT_THROW(open_scans(file, origin), Error);
  const ScanReadOptions ends{.frame = Frame::sensor, .end_points = true};
  EXPECT_THROW(open_scans(file, ends), Error);
}

TEST(ScanFile, warns_of_coarse_coordinates) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "a.xyz";
  write_text(file, "1 2 5648349.8\n");
  const auto source = open_scans(file, {.end_points = true});
  EXPECT_TRUE(source->notes().remarks.empty());
  for (Scan scan; source->next(scan);) {
  }
  ASSERT_EQ(source->notes().remarks.size(), 1u);
  EXPECT_NE(source->notes().remarks[0].find("in steps of 0.5 m"), std::string::npos);
  const auto shifted = open_scans(file, {.end_points = true, .offset = {0, 0, 5648300}});
  for (Scan scan; shifted->next(scan);) {
  }
  EXPECT_TRUE(shifted->notes().remarks.empty());
}

}  // namespace
}  // namespace rmap
