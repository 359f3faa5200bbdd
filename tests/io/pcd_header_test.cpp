#include "io/pcd_header.hpp"

#include "io/files.hpp"

#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::expect_error;

const std::string kHeader =
    "# .PCD v0.7 - Point Cloud Data file format\n"
    "VERSION 0.7\n"
    "FIELDS rgb z y x histogram\n"
    "SIZE 4 8 2 1 4\n"
    "TYPE U F I U F\n"
    "COUNT 1 1 1 1 33\n"
    "WIDTH 640\n"
    "HEIGHT 480\n"
    "VIEWPOINT 0 0 0 1 0 0 0\n"
    "POINTS 307200\n"
    "DATA binary\n";

// The header with a line, given by its key, replaced; or taken out, with "".
std::string changed(const std::string& key, const std::string& line) {
  const std::size_t begin = kHeader.find("\n" + key + " ") + 1;
  const std::size_t end = kHeader.find('\n', begin) + 1;
  return kHeader.substr(0, begin) + (line.empty() ? "" : line + "\n") + kHeader.substr(end);
}

TEST(PcdHeader, finds_the_coordinates_in_any_order_of_fields) {
  const PcdHeader header = parse_pcd_header("a.pcd", kHeader + "\n1 2 3");
  EXPECT_EQ(header.points, 307200u);
  EXPECT_EQ(header.data, PcdData::binary);
  EXPECT_EQ(header.size, kHeader.size());
  EXPECT_EQ(header.lines, 11u);
  EXPECT_EQ(header.point_size, 4u + 8 + 2 + 1 + 4 * 33);
  EXPECT_EQ(header.words, 37u);
  const auto& [x, y, z] = header.coordinates;
  EXPECT_EQ(std::tuple(x.type, x.offset, x.word), std::tuple(NumberType::u8, 14u, 3u));
  EXPECT_EQ(std::tuple(y.type, y.offset, y.word), std::tuple(NumberType::i16, 12u, 2u));
  EXPECT_EQ(std::tuple(z.type, z.offset, z.word), std::tuple(NumberType::f64, 4u, 1u));
}

TEST(PcdHeader, does_without_what_does_not_matter) {
  for (const std::string key : {"VERSION", "VIEWPOINT", "POINTS"}) {
    EXPECT_EQ(parse_pcd_header("a.pcd", changed(key, "")).points, 307200u) << key;
  }
  EXPECT_EQ(parse_pcd_header("a.pcd",
                             "FIELDS x y z\r\nSIZE 4 4 4\r\n\r\n# a comment\r\n"
                             "TYPE F F F\r\nPOINTS 7\r\nDATA ascii\r\n")
                .points,
            7u);
}

TEST(PcdHeader, names_what_is_missing) {
  for (const std::string key : {"FIELDS", "SIZE", "TYPE", "WIDTH", "HEIGHT", "DATA"}) {
    expect_error(ErrorKind::input, "a.pcd is no sound PCD file: the header has no " + key,
                 [&] { parse_pcd_header("a.pcd", changed(key, "")); });
  }
  expect_error(ErrorKind::input, "a.pcd is no sound PCD file: the header has no POINTS", [] {
    parse_pcd_header("a.pcd", "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nDATA ascii\n");
  });
  expect_error(ErrorKind::input, "a.pcd is no sound PCD file: the header has no DATA",
               [] { parse_pcd_header("a.pcd", ""); });
}

struct BadLine {
  std::string line;
  std::size_t number;
  std::string problem;
};

TEST(PcdHeader, names_line_value_and_what_is_allowed) {
  const std::vector<BadLine> cases = {
      {"VERSION 0.7\nVERSION 0.7", 3, "VERSION stands in line 2 already"},
      {"FIELDS rgb z y w histogram", 3,
       "FIELDS is \"rgb z y w histogram\", which must have x, y and z once each"},
      {"FIELDS x z y x histogram", 3,
       "FIELDS is \"x z y x histogram\", which must have x, y and z once each"},
      {"FIELDS z y x", 5, "TYPE has 5 entries, which must be one for each of the 3 FIELDS"},
      {"SIZE 4 8 2 1", 4, "SIZE has 4 entries, which must be one for each of the 5 FIELDS"},
      {"SIZE 4 2 2 1 4", 4, "SIZE of field \"z\" is \"2\", where 4 and 8 are allowed for TYPE F"},
      {"SIZE 4 8 3 1 4", 4,
       "SIZE of field \"y\" is \"3\", where 1, 2, 4 and 8 are allowed for TYPE I"},
      {"SIZE 4 8 2 0 4", 4,
       "SIZE of field \"x\" is \"0\", where 1, 2, 4 and 8 are allowed for TYPE U"},
      {"SIZE 4 -8 2 1 4", 4, "SIZE of field \"z\" is \"-8\", where 4 and 8 are allowed for TYPE F"},
      {"TYPE U D I U F", 5, "TYPE of field \"z\" is \"D\", where F, I and U are allowed"},
      {"TYPE U F I U", 5, "TYPE has 4 entries, which must be one for each of the 5 FIELDS"},
      {"COUNT 1 1 1 1 0", 6, "COUNT of field \"histogram\" is \"0\", where 1 to 65535 are allowed"},
      {"COUNT 1 1 1 1 99999999999999999999", 6,
       "COUNT of field \"histogram\" is \"99999999999999999999\", where 1 to 65535 are allowed"},
      {"COUNT 1 2 1 1 33", 6, "COUNT of z is 2, where 1 is allowed"},
      {"WIDTH -640", 7, "WIDTH is \"-640\", which must be a whole number from 0 to 2^64 - 1"},
      {"WIDTH", 7, "WIDTH has 0 entries, which must be one"},
      {"HEIGHT 1 2", 8, "HEIGHT has 2 entries, which must be one"},
      {"HEIGHT 18446744073709551615", 8,
       "WIDTH 640 times HEIGHT 18446744073709551615 is more than a file can hold"},
      {"POINTS 307201", 10, "POINTS is 307201, which must be WIDTH 640 times HEIGHT 480"},
      {"POINTS 3e5", 10, "POINTS is \"3e5\", which must be a whole number from 0 to 2^64 - 1"},
      {"DATA zip", 11, "DATA is \"zip\", where ascii, binary and binary_compressed are allowed"},
      {"VIEWPOINT\nBEGIN 5", 10,
       "the header has \"BEGIN\", where one of VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, "
       "VIEWPOINT, POINTS, DATA is allowed"}};
  for (const BadLine& bad : cases) {
    const std::string key = bad.line.substr(0, bad.line.find_first_of(" \n"));
    expect_error(ErrorKind::input, fmt::format("a.pcd, line {}: {}", bad.number, bad.problem),
                 [&] { parse_pcd_header("a.pcd", changed(key, bad.line)); });
  }
  EXPECT_EQ(cases.size(), 22u);
}

TEST(PcdHeader, knows_a_pcd_file_by_its_beginning) {
  EXPECT_TRUE(looks_like_pcd(kHeader));
  EXPECT_TRUE(looks_like_pcd("# made by hand\n\nFIELDS x y z\n"));
  EXPECT_FALSE(looks_like_pcd(""));
  EXPECT_FALSE(looks_like_pcd("ply\nformat ascii 1.0\n"));
  EXPECT_FALSE(looks_like_pcd("# just a comment\n"));
  EXPECT_FALSE(looks_like_pcd(test::bytes_of(std::vector<float>{1, 2, 3, 4})));
}

}  // namespace
}  // namespace rmap
