#include "io/bag/point_cloud.hpp"

#include "io/files.hpp"
#include "support/bag_messages.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::expect_error;
using test::TestCloud;

std::vector<Vector3f> points_of(const std::string& message) {
  std::vector<Vector3f> points = {{9, 9, 9}};
  decode_cloud(std::as_bytes(std::span(message)), points);
  return points;
}

template <class T>
std::string number(double value, bool big) {
  std::string raw = test::raw(static_cast<T>(value));
  if (big) std::reverse(raw.begin(), raw.end());
  return raw;
}

std::string number_of(std::uint8_t type, double value, bool big) {
  switch (type) {
    case 1:
      return number<std::int8_t>(value, big);
    case 2:
      return number<std::uint8_t>(value, big);
    case 3:
      return number<std::int16_t>(value, big);
    case 4:
      return number<std::uint16_t>(value, big);
    case 5:
      return number<std::int32_t>(value, big);
    case 6:
      return number<std::uint32_t>(value, big);
    case 7:
      return number<float>(value, big);
    default:
      return number<double>(value, big);
  }
}

TEST(PointCloud, keeps_floats_bit_for_bit) {
  const auto points = test::nasty_points();
  for (const bool big : {false, true}) {
    EXPECT_TRUE(test::same_bits(points_of(test::cloud_of(points, 5).message(big)), points));
  }
  EXPECT_TRUE(points_of(test::cloud_of({}, 5).message()).empty());
}

// Two rows of two points with gaps behind points and rows, fields backwards, for each type.
TEST(PointCloud, reads_every_type_and_layout) {
  int cases = 0;
  for (std::uint8_t type = 1; type <= 8; ++type) {
    for (const bool big : {false, true}) {
      const auto size = static_cast<std::uint32_t>(number_of(type, 0, big).size());
      TestCloud cloud;
      cloud.height = 2;
      cloud.width = 2;
      cloud.point_step = 3 + 4 * size + 5;
      cloud.row_step = 2 * cloud.point_step + 7;
      cloud.big_endian_data = big;
      cloud.fields = {{"intensity", 0, 7},
                      {"z", 3, type},
                      {"y", 3 + size, type, 2},
                      {"x", 3 + 3 * size, type, 0}};
      for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 2; ++column) {
          const double x = 10 * row + column;
          cloud.data += "abc" + number_of(type, x + 2, big) + number_of(type, x + 1, big) +
                        number_of(type, 99, big) + number_of(type, x, big) + "defgh";
        }
        cloud.data += "padding";
      }
      const std::vector<Vector3f> expected = {{0, 1, 2}, {1, 2, 3}, {10, 11, 12}, {11, 12, 13}};
      EXPECT_EQ(points_of(cloud.message()), expected) << int{type} << big;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 16);
}

TEST(PointCloud, makes_doubles_beyond_floats_infinite) {
  TestCloud cloud;
  cloud.width = 1;
  cloud.fields = {{"x", 0, 8}, {"y", 8, 8}, {"z", 16, 8}};
  cloud.point_step = cloud.row_step = 24;
  cloud.data = test::raw(1e300) + test::raw(0.1) + test::raw(std::nan(""));
  const auto points = points_of(cloud.message());
  EXPECT_EQ(points.at(0).x(), std::numeric_limits<float>::infinity());
  EXPECT_EQ(points.at(0).y(), 0.1F);
  EXPECT_TRUE(std::isnan(points.at(0).z()));
}

TEST(PointCloud, refuses_sizes_that_contradict_one_another) {
  const std::vector<Vector3f> points = {{1, 2, 3}, {4, 5, 6}};
  const TestCloud sound = test::cloud_of(points, 1);
  const auto expect = [&](const std::string& sentence, auto&& change) {
    TestCloud cloud = sound;
    change(cloud);
    expect_error(ErrorKind::input, sentence, [&] { points_of(cloud.message()); });
  };
  expect(
      "its 1 rows (height) of 25 bytes (row_step) take 25 bytes, and its data have 24: width 2, "
      "point_step 12",
      [](TestCloud& cloud) { cloud.row_step = 25; });
  expect(
      "its rows of 3 points (width) of 12 bytes (point_step) take 36 bytes, and have 24 "
      "(row_step)",
      [](TestCloud& cloud) { cloud.width = 3; });
  expect(
      "its rows of 4294967295 points (width) of 4294967295 bytes (point_step) take "
      "18446744065119617025 bytes, and have 24 (row_step)",
      [](TestCloud& cloud) { cloud.width = cloud.point_step = ~0U; });
  expect(
      "its 4294967295 rows (height) of 24 bytes (row_step) take 103079215080 bytes, and its "
      "data have 24: width 2, point_step 12",
      [](TestCloud& cloud) { cloud.height = ~0U; });
  expect("its field z ends at byte 12 of a point, which has 11 (point_step)",
         [](TestCloud& cloud) { cloud.point_step = 11; });
  expect("its field x ends at byte 17179869180 of a point, which has 12 (point_step)",
         [](TestCloud& cloud) { cloud.fields[0].count = ~0U; });
  expect("its field y is of type 9, where 1 (int8) to 8 (float64) are allowed",
         [](TestCloud& cloud) { cloud.fields[1].type = 9; });
  expect("two fields are called x, where one is allowed",
         [](TestCloud& cloud) { cloud.fields[1].name = "x"; });
  expect("it has no field z: its fields are \"x\", \"y\", \"range\"",
         [](TestCloud& cloud) { cloud.fields[2].name = "range"; });
}

TEST(PointCloud, cut_anywhere_is_an_error) {
  const std::vector<Vector3f> points = {{1, 2, 3}, {4, 5, 6}};
  const std::string message = test::cloud_of(points, 1).message();
  // The last byte says whether all points are finite: nobody needs it.
  for (std::size_t size = 0; size + 1 < message.size(); ++size) {
    EXPECT_THROW(points_of(message.substr(0, size)), Error) << size;
  }
}

}  // namespace
}  // namespace rmap
