#include "io/point_formats.hpp"

#include "io/files.hpp"

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
  EXPECT_EQ(point_endings(), ".bin and .pcd");
}

TEST(PointFormats, refuses_other_endings) {
  const test::TemporaryFolder folder;
  for (const std::string ending : {"", ".txt", ".rmap"}) {
    const std::string file = folder / ("a" + ending);
    const std::string sentence =
        fmt::format("the ending of {} is \"{}\", where .bin and .pcd are allowed", file, ending);
    expect_error(ErrorKind::input, sentence, [&] { read_points(file); });
    expect_error(ErrorKind::input, sentence, [&] { write_points(file, {}); });
  }
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
