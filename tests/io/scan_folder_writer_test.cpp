#include "io/files.hpp"
#include "support/random.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::expect_error;
using testing::ElementsAre;

std::vector<Scan> random_scans(test::Random& random, int count) {
  std::vector<Scan> scans(static_cast<std::size_t>(count));
  for (Scan& scan : scans) {
    scan.map_from_sensor = make_pose(
        random.point(-50, 50), Eigen::Quaterniond(random.real(0.1, 1), random.real(-1, 1), 0, 0));
    scan.points.resize(static_cast<std::size_t>(random.integer(1, 300)));
    for (Vector3f& point : scan.points) point = random.point(-9, 9).cast<float>();
  }
  return scans;
}

TEST(ScanFolderWriter, writes_what_is_read_back) {
  test::Random random(9);
  SCOPED_TRACE(random.trace());
  for (const std::string ending : {".bin", ".pcd"}) {
    const test::TemporaryFolder folder;
    const auto scans = random_scans(random, 12);
    ScanFolderWriter writer(folder / "deep/down", ending);
    for (const Scan& scan : scans) writer.add(scan);
    writer.finish();
    std::size_t index = 0;
    for (const Scan& scan : read_scans(folder / "deep/down")) {
      EXPECT_EQ(scan.map_from_sensor.matrix(), scans.at(index).map_from_sensor.matrix());
      EXPECT_TRUE(test::same_bits(scan.points, scans.at(index).points));
      ++index;
    }
    EXPECT_EQ(index, 12u);
  }
}

TEST(ScanFolderWriter, leaves_no_poses_before_the_end) {
  test::Random random(10);
  SCOPED_TRACE(random.trace());
  const test::TemporaryFolder folder;
  ScanFolderWriter writer(folder.path());
  for (const Scan& scan : random_scans(random, 2)) writer.add(scan);
  EXPECT_THAT(folder.names(), ElementsAre("000000.bin", "000001.bin"));
  writer.finish();
  EXPECT_THAT(folder.names(), ElementsAre("000000.bin", "000001.bin", "poses.txt"));
}

TEST(ScanFolderWriter, refuses_what_it_cannot_write) {
  const test::TemporaryFolder folder;
  const std::string name = folder.path();
  expect_error(ErrorKind::input,
               "the ending of the scans is \".ply\", where .bin and .pcd are allowed",
               [&] { ScanFolderWriter(folder.path(), ".ply"); });
  ScanFolderWriter writer(folder.path());
  expect_error(
      ErrorKind::usage,
      "scan 0 is in the map's frame: the scans of " + name + " must be in the sensor's frame", [&] {
        writer.add({.frame = Frame::map, .points = {{1, 2, 3}}});
      });
  writer.add({.points = {{1, 2, 3}}});
  const std::string used = name + " holds scans or poses already: it must be a folder without them";
  expect_error(ErrorKind::input, used, [&] { ScanFolderWriter(folder.path()); });
  std::filesystem::remove(folder / "000000.bin");
  test::write_text(folder / "poses.txt", "");
  expect_error(ErrorKind::input, used, [&] { ScanFolderWriter(folder.path()); });
  test::write_text(folder / "file", "");
  const std::string inside_file = folder / "file/scans";
  expect_error(ErrorKind::io, "cannot create " + inside_file + ": Not a directory",
               [&] { ScanFolderWriter{inside_file}; });
}

}  // namespace
}  // namespace rmap
