#include "io/bin_file.hpp"

#include "io/files.hpp"
#include "support/random.hpp"

#include <limits>

#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::same_bits;

TEST(BinFile, reads_four_floats_a_point) {
  const test::TemporaryFolder folder;
  const std::vector<float> numbers = {1, 2, 3, 0.5F, -4, 5.5F, 1e-3F, 99};
  test::write_text(folder / "a.bin", test::bytes_of(numbers));
  EXPECT_TRUE(same_bits(read_points(folder / "a.bin"),
                        std::vector<Vector3f>{{1, 2, 3}, {-4, 5.5F, 1e-3F}}));
}

TEST(BinFile, gives_back_the_bits_that_were_written) {
  const test::TemporaryFolder folder;
  write_points(folder / "a.bin", test::nasty_points());
  EXPECT_EQ(std::filesystem::file_size(folder / "a.bin"), 16 * test::nasty_points().size());
  EXPECT_TRUE(same_bits(read_points(folder / "a.bin"), test::nasty_points()));

  // Around the sizes at which reading and writing go from one piece to the next.
  test::Random random(6);
  SCOPED_TRACE(random.trace());
  int cases = 0;
  for (const std::size_t count : {1u, 2u, 16383u, 16384u, 16385u, 50000u}) {
    std::vector<Vector3f> points(count);
    for (Vector3f& point : points) point = random.point(-100, 100).cast<float>();
    write_points(folder / "a.bin", points);
    ASSERT_TRUE(same_bits(read_points(folder / "a.bin"), points)) << count;
    ++cases;
  }
  EXPECT_EQ(cases, 6);
}

TEST(BinFile, refuses_sizes_that_cannot_be) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.bin";
  test::write_text(file, "");
  expect_error(ErrorKind::input,
               file + " is empty: a .bin scan holds at least one point of 16 bytes",
               [&] { read_points(file); });
  test::write_text(file, std::string(40, 'x'));
  expect_error(ErrorKind::input,
               file +
                   " has 40 bytes: a .bin scan holds 16 bytes a point (float32 x, y, z, "
                   "intensity), and 8 are left over",
               [&] { read_points(file); });
}

TEST(BinFile, refuses_more_points_than_memory_is_meant_for) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.bin";
  test::write_text(file, "");
  // A hole: it takes no disk.
  std::filesystem::resize_file(file, 16 * (std::uintmax_t{1} << 36));
  expect_error(ErrorKind::limit,
               file + " holds 68719476736 points: 268435456 are allowed in a file",
               [&] { read_points(file); });
}

TEST(BinFile, is_not_written_without_points) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.bin";
  expect_error(ErrorKind::input,
               "there are no points to write to " + file +
                   ": a .bin scan holds at least one, a .pcd may hold none",
               [&] { write_points(file, {}); });
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace rmap
