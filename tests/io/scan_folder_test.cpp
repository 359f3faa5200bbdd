#include "io/scan_folder.hpp"

#include "io/files.hpp"
#include "io/scan_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::write_text;

void write_scan(const std::filesystem::path& file, float x) {
  write_points(file, std::vector<Vector3f>{{x, 0, 0}});
}

// Poses that are known by their x.
void write_poses_along_x(const std::filesystem::path& folder, int count) {
  std::vector<Pose> poses;
  for (int i = 0; i < count; ++i) {
    poses.push_back(Pose::Identity());
    poses.back().translation().x() = i;
  }
  write_poses(folder / "poses.txt", poses);
}

std::vector<float> xs_of(const std::filesystem::path& path) {
  std::vector<float> xs;
  const auto source = open_scans(path);
  for (Scan scan; source->next(scan);) xs.push_back(scan.points.at(0).x());
  return xs;
}

TEST(ScanFolder, gives_scans_in_natural_order_with_their_poses) {
  const test::TemporaryFolder folder;
  for (const int number : {10, 9, 100, 1, 2}) {
    write_scan(folder / fmt::format("scan{}.bin", number), static_cast<float>(number));
  }
  write_poses_along_x(folder.path(), 5);
  const auto source = open_scan_folder(folder.path(), {});
  EXPECT_EQ(source->size(), 5u);
  const std::vector<float> expected = {1, 2, 9, 10, 100};
  // Whatever a scan held before is gone.
  Scan scan{.frame = Frame::map,
            .points = std::vector<Vector3f>(7),
            .origins = std::vector<Vector3d>(7),
            .no_returns = std::vector<Vector3f>(2),
            .sensor_range = 5};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_TRUE(source->next(scan));
    EXPECT_EQ(scan.map_from_sensor.translation().x(), static_cast<double>(i));
    EXPECT_EQ(scan.frame, Frame::sensor);
    ASSERT_EQ(scan.points.size(), 1u);
    EXPECT_EQ(scan.points[0].x(), expected[i]);
    EXPECT_TRUE(scan.origins.empty());
    EXPECT_TRUE(scan.no_returns.empty());
    EXPECT_EQ(scan.sensor_range, std::numeric_limits<double>::infinity());
    EXPECT_EQ(scan.name, (folder / fmt::format("scan{}.bin", expected[i])).string());
  }
  EXPECT_FALSE(source->next(scan));
  EXPECT_FALSE(source->next(scan));
  source->rewind();
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.points[0].x(), 1);
}

TEST(ScanFolder, passes_over_what_is_no_scan) {
  const test::TemporaryFolder folder;
  write_scan(folder / "0.pcd", 0);
  write_scan(folder / "1.PCD", 1);
  write_poses_along_x(folder.path(), 2);
  write_text(folder / "README.md", "text");
  write_text(folder / "._0.pcd", "what another system leaves behind");
  std::filesystem::create_directory(folder / "images");
  std::filesystem::create_symlink(folder / "0.pcd", folder / "link.txt");
  EXPECT_EQ(xs_of(folder.path()), (std::vector<float>{0, 1}));
}

TEST(ScanFolder, follows_links_to_scans) {
  const test::TemporaryFolder elsewhere;
  write_scan(elsewhere / "x.bin", 5);
  const test::TemporaryFolder folder;
  std::filesystem::create_symlink(elsewhere / "x.bin", folder / "0.bin");
  write_poses_along_x(folder.path(), 1);
  EXPECT_EQ(xs_of(folder.path()), (std::vector<float>{5}));
  EXPECT_EQ(xs_of(folder / "0.bin"), (std::vector<float>{5}));
}

TEST(ScanFolder, gives_one_file_the_pose_of_its_place) {
  const test::TemporaryFolder folder;
  for (int i = 8; i < 12; ++i) {
    write_scan(folder / fmt::format("{}.bin", i), static_cast<float>(i));
  }
  write_poses_along_x(folder.path(), 4);
  const auto source = open_scan_file(folder / "10.bin", {});
  EXPECT_EQ(source->size(), 1u);
  Scan scan;
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.points[0].x(), 10);
  EXPECT_EQ(scan.map_from_sensor.translation().x(), 2);
  EXPECT_EQ(scan.name, (folder / "10.bin").string());
  EXPECT_FALSE(source->next(scan));
}

TEST(ScanFolder, goes_on_behind_a_scan_that_cannot_be_read) {
  const test::TemporaryFolder folder;
  for (int i = 0; i < 4; ++i) {
    write_scan(folder / fmt::format("{}.bin", i), static_cast<float>(i));
  }
  write_poses_along_x(folder.path(), 4);
  write_text(folder / "1.bin", "garbage");
  std::filesystem::remove(folder / "3.bin");
  write_text(folder / "3.bin", "");
  const auto source = open_scan_folder(folder.path(), {});
  std::vector<float> good;
  int bad = 0;
  for (Scan scan;;) {
    try {
      if (!source->next(scan)) break;
      good.push_back(scan.points.at(0).x());
    } catch (const Error&) {
      ++bad;
    }
  }
  EXPECT_EQ(good, (std::vector<float>{0, 2}));
  EXPECT_EQ(bad, 2);
}

TEST(ScanFolder, names_what_is_missing_or_too_many) {
  const test::TemporaryFolder folder;
  const std::string name = folder.path();
  const std::string none = name +
                           " holds no scans: files ending in .bin, .pcd, .ply, .las, .laz, .3d, "
                           ".xyz and .csv are allowed";
  expect_error(ErrorKind::input, none, [&] { open_scans(name); });
  write_text(folder / "notes.txt", "no scan");
  write_poses_along_x(folder.path(), 1);
  expect_error(ErrorKind::input, none, [&] { open_scans(name); });

  write_scan(folder / "0.bin", 0);
  write_scan(folder / "1.bin", 1);
  const std::string poses = folder / "poses.txt";
  for (const int count : {0, 1, 3}) {
    write_poses_along_x(folder.path(), count);
    const std::string sentence =
        fmt::format("{} holds {} poses and {} holds 2 scans: there must be one pose for each scan",
                    poses, count, name);
    expect_error(ErrorKind::input, sentence, [&] { open_scans(name); });
    expect_error(ErrorKind::input, sentence, [&] { open_scans(folder / "1.bin"); });
  }
  std::filesystem::remove(poses);
  const std::string missing =
      poses + " is missing: it must hold one pose for each of the 2 scans of " + name +
      ". Or name a file of poses (--trajectory), or build from end points (--end-points)";
  expect_error(ErrorKind::input, missing, [&] { open_scans(name); });
}

TEST(ScanFolder, takes_text_for_scans_where_nothing_else_is) {
  const test::TemporaryFolder folder;
  write_text(folder / "0.csv", "1 0 0\n");
  write_text(folder / "1.csv", "2 0 0\n");
  write_poses_along_x(folder.path(), 2);
  EXPECT_EQ(xs_of(folder.path()), (std::vector<float>{1, 2}));
  // Beside scans a table is something else.
  write_scan(folder / "0.bin", 3);
  write_scan(folder / "1.bin", 4);
  EXPECT_EQ(xs_of(folder.path()), (std::vector<float>{3, 4}));
}

TEST(ScanFolder, takes_one_format_only) {
  const test::TemporaryFolder folder;
  write_scan(folder / "0.bin", 0);
  write_scan(folder / "0.pcd", 0);
  write_poses_along_x(folder.path(), 2);
  const std::string name = folder.path();
  expect_error(ErrorKind::input,
               name +
                   " holds scans in two formats, 0.bin and 0.pcd for example: one is allowed in "
                   "a folder",
               [&] { open_scans(name); });
}

TEST(ScanFolder, refuses_what_only_has_the_name_of_a_scan) {
  const test::TemporaryFolder folder;
  write_scan(folder / "0.bin", 0);
  write_poses_along_x(folder.path(), 2);
  const std::string other = folder / "1.bin";
  std::filesystem::create_directory(other);
  expect_error(ErrorKind::input,
               other + " is a folder, and must be a regular file as its name says",
               [&] { open_scans(folder.path()); });
  std::filesystem::remove(other);
  std::filesystem::create_symlink("nowhere", other);
  expect_error(ErrorKind::io, "cannot open " + other + ": No such file or directory",
               [&] { open_scans(folder.path()); });
}

}  // namespace
}  // namespace rmap
