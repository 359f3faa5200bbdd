#include "io/folder_poses.hpp"

#include "io/files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::write_text;

void write_scans(const std::filesystem::path& folder, int count) {
  std::filesystem::create_directories(folder);
  for (int i = 0; i < count; ++i) {
    write_points(folder / fmt::format("{:06}.bin", i),
                 std::vector<Vector3f>{{static_cast<float>(i), 0, 0}});
  }
}

std::vector<double> xs_of_poses(const std::filesystem::path& path, const ScanReadOptions& options) {
  std::vector<double> xs;
  for (const Scan& scan : read_scans(path, options)) {
    xs.push_back(scan.map_from_sensor.translation().x());
  }
  return xs;
}

TEST(FolderPoses, come_from_a_trajectory_in_order_or_by_time) {
  const test::TemporaryFolder folder;
  write_scans(folder / "scans", 3);
  const std::filesystem::path file = folder / "poses.tum";
  write_text(file, "10 1 0 0 0 0 0 1\n11 2 0 0 0 0 0 1\n12 3 0 0 0 0 0 1\n");
  const ScanReadOptions options{.trajectory = file};
  EXPECT_EQ(xs_of_poses(folder / "scans", options), (std::vector<double>{1, 2, 3}));

  // The folder's own times say where on the way each scan was.
  write_text(folder / "scans/times.txt", "10.5\n11\n13\n");
  const auto source = open_scans(folder / "scans", options);
  Scan scan;
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.map_from_sensor.translation().x(), 1.5);
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.map_from_sensor.translation().x(), 2);
  EXPECT_FALSE(source->next(scan));
  EXPECT_EQ(source->notes().without_pose, 1u);

  write_text(folder / "scans/times.txt", "10.5\n11\n");
  EXPECT_THROW(open_scans(folder / "scans", options), Error);
  write_text(folder / "times", "12\n10\n11\n");
  EXPECT_EQ(xs_of_poses(folder / "scans", {.trajectory = file, .times = folder / "times"}),
            (std::vector<double>{3, 1, 2}));
}

TEST(FolderPoses, have_the_offset_taken_off) {
  const test::TemporaryFolder folder;
  write_scans(folder.path(), 1);
  write_text(folder / "poses.txt", "1 0 0 494000.5  0 1 0 2  0 0 1 3\n");
  EXPECT_EQ(xs_of_poses(folder.path(), {.offset = {494000, 0, 0}}), (std::vector<double>{0.5}));
}

TEST(FolderPoses, know_the_order_of_quaternions_by_the_option) {
  const test::TemporaryFolder folder;
  write_scans(folder.path(), 1);
  write_text(folder / "poses.txt", "0 0 0 0 0 0 1\n");
  const auto turned = [&](QuaternionOrder order) {
    const auto source = open_scans(folder.path(), {.quaternion = order});
    Scan scan;
    EXPECT_TRUE(source->next(scan));
    return rotated(scan.map_from_sensor, {1, 0, 0});
  };
  EXPECT_EQ(turned(QuaternionOrder::xyzw), Vector3d(1, 0, 0));
  EXPECT_EQ(turned(QuaternionOrder::wxyz), Vector3d(-1, 0, 0));
}

TEST(FolderPoses, follow_kittis_layout) {
  const test::TemporaryFolder folder;
  const std::filesystem::path sequence = folder / "sequences/07";
  write_scans(sequence / "velodyne", 2);
  std::filesystem::create_directories(folder / "poses");
  write_text(folder / "poses/07.txt", "1 0 0 5 0 1 0 0 0 0 1 0\n1 0 0 6 0 1 0 0 0 0 1 0\n");
  EXPECT_EQ(xs_of_poses(sequence, {}), (std::vector<double>{5, 6}));
  EXPECT_NE(open_scans(sequence)->notes().remarks.at(0).find("taken as those of the lidar"),
            std::string::npos);
  write_text(sequence / "calib.txt", "P0: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_THROW(open_scans(sequence), Error);
  // Half a turn and a step from the lidar to the camera.
  write_text(sequence / "calib.txt",
             "P0: 1 0 0 0 0 1 0 0 0 0 1 0\nTr: -1 0 0 0.25 0 -1 0 0 0 0 1 0\n");
  const auto source = open_scans(sequence);
  Scan scan;
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.map_from_sensor.translation().x(), 5.25);
  EXPECT_EQ(rotated(scan.map_from_sensor, {1, 0, 0}), Vector3d(-1, 0, 0));
  ASSERT_EQ(source->notes().remarks.size(), 1u);
  EXPECT_NE(source->notes().remarks[0].find("KITTI's camera"), std::string::npos);

  write_text(sequence / "calib.txt", "Tr: 1 2 3\n");
  expect_error(ErrorKind::input,
               (sequence / "calib.txt").string() +
                   ", line 1: \"\" stands where one of the 12 numbers of a 3x4 matrix must be",
               [&] { open_scans(sequence); });
}

TEST(FolderPoses, are_not_needed_for_ends_alone) {
  const test::TemporaryFolder folder;
  write_scans(folder.path(), 2);
  const ScanReadOptions ends{.end_points = true};
  EXPECT_EQ(xs_of_poses(folder.path(), ends), (std::vector<double>{0, 0}));
  // Scans with poses are in the sensor's frame unless it is said that they are not.
  write_text(folder / "poses.txt", "1 0 0 5 0 1 0 0 0 0 1 0\n1 0 0 6 0 1 0 0 0 0 1 0\n");
  EXPECT_THROW(open_scans(folder.path(), ends), Error);
  EXPECT_EQ(xs_of_poses(folder.path(), {.frame = Frame::map, .end_points = true}),
            (std::vector<double>{0, 0}));
}

TEST(FolderPoses, in_the_files_will_do) {
  const test::TemporaryFolder folder;
  for (const int i : {0, 1}) {
    write_text(folder / fmt::format("{}.pcd", i),
               fmt::format("FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nWIDTH 1\nHEIGHT 1\n"
                           "VIEWPOINT {} 0 0 1 0 0 0\nDATA ascii\n1 2 3\n",
                           i));
  }
  // The first one is the identity and means it.
  EXPECT_EQ(xs_of_poses(folder.path(), {}), (std::vector<double>{0, 1}));
}

TEST(FolderPoses, of_points_in_the_world_give_the_origin) {
  const test::TemporaryFolder folder;
  write_scans(folder.path(), 1);
  write_text(folder / "poses.txt", "1 0 0 1005 0 1 0 0 0 0 1 0\n");
  const auto source = open_scans(folder.path(), {.frame = Frame::map, .offset = {1000, 0, 0}});
  Scan scan;
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.frame, Frame::map);
  EXPECT_EQ(scan.points.at(0), Vector3f(-1000, 0, 0));
  EXPECT_EQ(scan.map_from_sensor.translation().x(), 5);
}

}  // namespace
}  // namespace rmap
