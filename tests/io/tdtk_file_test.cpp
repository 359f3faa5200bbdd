#include "io/tdtk_file.hpp"

#include "io/files.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::same_bits;
using test::write_text;

TEST(TdtkFile, turns_left_handed_centimetres) {
  const test::TemporaryFolder folder;
  write_text(folder / "a.3d", "100 200 300\n# text\n-50 0 25 0.7 12\n");
  EXPECT_TRUE(
      same_bits(read_points(folder / "a.3d"), std::vector<Vector3f>{{3, -1, 2}, {0.25F, 0.5F, 0}}));
  expect_error(
      ErrorKind::input,
      (folder / "b.3d").string() +
          ", line 1: \"1 2\" is no point of 3DTK, which begins with the three numbers x y z",
      [&] {
        write_text(folder / "b.3d", "1 2\n");
        read_points(folder / "b.3d");
      });
}

TEST(TdtkFile, turns_poses) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.pose";
  // A turn by 90 degrees about y, which points up, from z ahead to x right: clockwise from above.
  write_text(file, "100 200 300\n0 90 0\n");
  const Pose pose = read_3dtk_pose(file);
  EXPECT_TRUE(pose.translation().isApprox(Vector3d(3, -1, 2)));
  EXPECT_TRUE(transformed(pose, {1, 0, 0}).isApprox(Vector3d(3, -2, 2)));
  EXPECT_TRUE(transformed(pose, {0, 1, 0}).isApprox(Vector3d(4, -1, 2)));
  for (const std::string text : {"1 2 3\n4 5\n", "1 2 3 4 5 6 7", "1 2 x 4 5 6", "1 2 nan 4 5 6"}) {
    write_text(file, text);
    EXPECT_THROW(read_3dtk_pose(file), Error) << text;
  }
}

TEST(TdtkFile, agrees_with_its_own_axes) {
  // What 3DTK does: turn about x, then about y, then about z, all in its axes.
  const test::TemporaryFolder folder;
  write_text(folder / "a.pose", "10 -20 30\n12 34 -56\n");
  const Pose pose = read_3dtk_pose(folder / "a.pose");
  const auto axis = [](double degrees, const Vector3d& of) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, of).toRotationMatrix();
  };
  const Eigen::Matrix3d turn =
      axis(12, Vector3d::UnitX()) * axis(34, Vector3d::UnitY()) * axis(-56, Vector3d::UnitZ());
  const Vector3d point(70, 80, 90);
  const Vector3d there = turn * point + Vector3d(10, -20, 30);
  const Vector3f ours = Vector3f(90, -70, 80) * 0.01F;
  EXPECT_LT((transformed(pose, ours) - Vector3d(there.z(), -there.x(), there.y()) * 0.01).norm(),
            1e-6);
}

TEST(TdtkFile, folders_need_no_other_poses) {
  const test::TemporaryFolder folder;
  for (const std::string name : {"scan000", "scan001"}) {
    write_text(folder / (name + ".3d"), "100 200 300\n");
    write_text(folder / (name + ".pose"), "0 0 100\n0 0 0\n");
  }
  std::size_t scans = 0;
  for (const Scan& scan : read_scans(folder.path())) {
    EXPECT_EQ(scan.map_from_sensor.translation(), Vector3d(1, 0, 0));
    EXPECT_EQ(scan.points.at(0), Vector3f(3, -1, 2));
    ++scans;
  }
  EXPECT_EQ(scans, 2u);
  const auto one = open_scans(folder / "scan001.3d");
  Scan scan;
  ASSERT_TRUE(one->next(scan));
  EXPECT_EQ(scan.map_from_sensor.translation(), Vector3d(1, 0, 0));
}

}  // namespace
}  // namespace rmap
