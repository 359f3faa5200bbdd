#include "io/point_formats.hpp"

#include "io/files.hpp"

#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::same_bits;

TEST(PointFormats, go_by_the_ending_in_any_case) {
  const test::TemporaryFolder folder;
  const std::vector<Vector3f> points = {{1, 2, 3}};
  for (const std::string name : {"a.bin", "a.BIN", "a.pcd", "a.PcD", "a.b.pcd"}) {
    write_points(folder / name, points);
    EXPECT_TRUE(same_bits(read_points(folder / name), points)) << name;
  }
  EXPECT_EQ(ending_of("a/b.c/d"), "");
  EXPECT_EQ(point_endings(), ".bin, .pcd, .ply, .las, .laz, .3d, .xyz, .csv, .txt and .dat");
  EXPECT_EQ(folder_endings(), ".bin, .pcd, .ply, .las, .laz, .3d, .xyz and .csv");
}

TEST(PointFormats, refuses_other_endings) {
  const test::TemporaryFolder folder;
  for (const std::string ending : {"", ".doc", ".rmap"}) {
    const std::string file = folder / ("a" + ending);
    const std::string sentence = fmt::format("the ending of {} is \"{}\", where {} are allowed",
                                             file, ending, point_endings());
    expect_error(ErrorKind::input, sentence, [&] { read_points(file); });
    expect_error(ErrorKind::input, sentence, [&] { write_points(file, {}); });
  }
}

TEST(PointFormats, says_what_is_only_read) {
  expect_error(
      ErrorKind::input,
      "a.ply cannot be written: points are written as .bin and .pcd, and .ply is only read",
      [] { write_points("a.ply", {}); });
}

TEST(PointFormats, takes_the_offset_off_before_rounding) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.xyz", "665187.522077 5648349.895035 241.767693\n");
  const ScanReadOptions options{.offset = {665187, 5648349, 240}};
  EXPECT_TRUE(same_bits(read_points(folder / "a.xyz", options),
                        std::vector<Vector3f>{{static_cast<float>(665187.522077 - 665187),
                                               static_cast<float>(5648349.895035 - 5648349),
                                               static_cast<float>(241.767693 - 240)}}));
  // Points of the sensor's frame have nothing to do with it.
  const ScanReadOptions in_sensor{.frame = Frame::sensor, .offset = {665187, 5648349, 240}};
  EXPECT_EQ(read_points(folder / "a.xyz", in_sensor).at(0).x(), 665187.522077F);
  // Floats are as exact as they were.
  write_points(folder / "a.bin", std::vector<Vector3f>{{100, 200, 0.1F}});
  EXPECT_TRUE(same_bits(read_points(folder / "a.bin", {.offset = {99, 200, 0}}),
                        std::vector<Vector3f>{{1, 0, 0.1F}}));
}

TEST(PointFormats, knows_how_coarse_floats_are) {
  const test::TemporaryFolder folder;
  PointCloud cloud;
  test::write_text(folder / "a.xyz", "1 2 5648349.8\n");
  EXPECT_EQ(read_cloud(folder / "a.xyz", {}, cloud), 0.5);
  EXPECT_EQ(read_cloud(folder / "a.xyz", {.in_map = true, .offset = {0, 0, 5648300}}, cloud), 0);
  // What the file itself has rounded no offset brings back.
  write_points(folder / "a.bin", std::vector<Vector3f>{{1, 2, 5648349.8F}});
  EXPECT_EQ(read_cloud(folder / "a.bin", {.in_map = true, .offset = {0, 0, 5648300}}, cloud), 0.5);
  write_points(folder / "a.bin", test::nasty_points());
  EXPECT_GT(read_cloud(folder / "a.bin", {}, cloud), 0);
  write_points(folder / "a.bin", std::vector<Vector3f>{{1e5F, -1e5F, std::nanf("")}});
  EXPECT_EQ(read_cloud(folder / "a.bin", {}, cloud), 0);
}

TEST(PointFormats, checks_the_name_by_the_content) {
  const test::TemporaryFolder folder;
  // Large enough that its size would do for a .bin.
  write_points(folder / "a.pcd", std::vector<Vector3f>(400, Vector3f::Ones()));
  std::string bytes = test::read_text(folder / "a.pcd");
  bytes.resize(bytes.size() / 16 * 16);
  const std::string file = folder / "b.bin";
  test::write_text(file, bytes);
  expect_error(ErrorKind::input, file + " is named as a .bin file and holds a .pcd file",
               [&] { read_points(file); });
}

TEST(PointFormats, refuses_folders_named_as_files) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "a.bin");
  const std::string file = folder / "a.bin";
  expect_error(ErrorKind::io,
               "cannot read " + file + ": it is a folder, and must be a regular file",
               [&] { read_points(file); });
}

}  // namespace
}  // namespace rmap
