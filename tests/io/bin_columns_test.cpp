#include "io/bin_columns.hpp"

#include "io/files.hpp"

#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::raw;
using test::same_bits;

TEST(BinColumns, takes_names_and_types) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.bin";
  std::string bytes;
  for (int i = 0; i < 3; ++i) {
    bytes += raw(static_cast<std::uint16_t>(i)) + raw(static_cast<float>(i) + 0.5F) +
             raw(i + 0.25) + raw(static_cast<std::int8_t>(-i));
  }
  test::write_text(file, bytes);
  EXPECT_TRUE(
      same_bits(read_points(file, {.columns = {"ring:u16", "z", "x:f64", "y:i8"}}),
                std::vector<Vector3f>{{0.25F, 0, 0.5F}, {1.25F, -1, 1.5F}, {2.25F, -2, 2.5F}}));
}

TEST(BinColumns, says_what_is_wrong) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.bin";
  test::write_text(file, std::string(50, '\0'));
  expect_error(ErrorKind::usage,
               "the columns of .bin files are x,y: there must be x, y and z once each", [&] {
                 read_points(file, {.columns = {"x", "y"}});
               });
  expect_error(ErrorKind::usage,
               "the column \"z:f16\" of .bin files has the type \"f16\", where i8, u8, i16, u16, "
               "i32, u32, i64, u64, f32 and f64 are allowed",
               [&] {
                 read_points(file, {.columns = {"x", "y", "z:f16"}});
               });
  expect_error(ErrorKind::input,
               file +
                   " has 50 bytes: a .bin scan holds 20 bytes a point (x, y, z, i, ring), and 10 "
                   "are left over",
               [&] {
                 read_points(file, {.columns = {"x", "y", "z", "i", "ring"}});
               });
}

}  // namespace
}  // namespace rmap
