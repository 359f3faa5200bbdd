#include "io/pcd_file.hpp"

#include "io/files.hpp"
#include "support/random.hpp"

#include <limits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::raw;
using test::same_bits;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::string header(const std::string& layout, std::uint64_t points, const std::string& data) {
  return fmt::format("VERSION .7\n{}WIDTH {}\nHEIGHT 1\nPOINTS {}\nDATA {}\n", layout, points,
                     points, data);
}

const std::string kXyz = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n";

std::vector<Vector3f> read_text_as_pcd(const std::string& text) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.pcd", text);
  return read_points(folder / "a.pcd");
}

// LZF without any reference: every byte as it is.
std::string stored(const std::string& bytes) {
  std::string lzf;
  for (std::size_t begin = 0; begin < bytes.size(); begin += 32) {
    const std::string piece = bytes.substr(begin, 32);
    lzf += static_cast<char>(piece.size() - 1) + piece;
  }
  return lzf;
}

std::string compressed_data(const std::string& lzf, std::size_t size) {
  return raw(static_cast<std::uint32_t>(lzf.size())) + raw(static_cast<std::uint32_t>(size)) + lzf;
}

TEST(PcdFile, reads_ascii) {
  const auto points =
      read_text_as_pcd(header(kXyz, 3, "ascii") + "1 -2.5 +3e-1\n\nnan inf -inf\r\n" + "\t7 8  9");
  const float infinity = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(same_bits(
      points, std::vector<Vector3f>{{1, -2.5F, 0.3F}, {kNan, infinity, -infinity}, {7, 8, 9}}));
}

TEST(PcdFile, reads_ascii_with_other_fields_between) {
  const std::string layout =
      "FIELDS rgb z h y x\nSIZE 4 8 4 4 4\nTYPE F F F F F\nCOUNT 1 1 2 1 1\n";
  EXPECT_TRUE(same_bits(read_text_as_pcd(header(layout, 1, "ascii") + "4e6 3 nan 0 2 1\n"),
                        std::vector<Vector3f>{{1, 2, 3}}));
}

TEST(PcdFile, reads_binary_with_other_fields_between) {
  const std::string layout =
      "FIELDS _ z y label x\nSIZE 1 8 4 2 4\nTYPE U F F U F\nCOUNT 3 1 1 1 1\n";
  std::string data;
  for (const float i : {0.0F, 1.0F}) {
    data += "pad" + raw(static_cast<double>(i) + 0.25) + raw(i + 0.5F) + raw(std::uint16_t{9}) +
            raw(i + 0.75F);
  }
  EXPECT_TRUE(same_bits(read_text_as_pcd(header(layout, 2, "binary") + data),
                        std::vector<Vector3f>{{0.75F, 0.5F, 0.25F}, {1.75F, 1.5F, 1.25F}}));
}

template <class T>
void expect_reads(const std::string& size_and_type, T x, T y, T z) {
  const std::string data = raw(x) + raw(y) + raw(z);
  const std::vector<Vector3f> expected = {
      {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)}};
  EXPECT_TRUE(same_bits(
      read_text_as_pcd(header("FIELDS x y z\n" + size_and_type, 1, "binary") + data), expected))
      << size_and_type;
  EXPECT_TRUE(
      same_bits(read_text_as_pcd(header("FIELDS x y z\n" + size_and_type, 1, "binary_compressed") +
                                 compressed_data(stored(data), data.size())),
                expected))
      << size_and_type;
}

TEST(PcdFile, reads_coordinates_of_every_type) {
  expect_reads<float>("SIZE 4 4 4\nTYPE F F F\n", 1.5F, kNan, -3);
  expect_reads<double>("SIZE 8 8 8\nTYPE F F F\n", 0.1, 1e300, -1e-300);
  expect_reads<std::int8_t>("SIZE 1 1 1\nTYPE I I I\n", -128, 127, 0);
  expect_reads<std::uint8_t>("SIZE 1 1 1\nTYPE U U U\n", 255, 1, 0);
  expect_reads<std::int16_t>("SIZE 2 2 2\nTYPE I I I\n", -32768, 32767, -1);
  expect_reads<std::uint16_t>("SIZE 2 2 2\nTYPE U U U\n", 65535, 1, 0);
  expect_reads<std::int32_t>("SIZE 4 4 4\nTYPE I I I\n", -2147483647, 16777217, -1);
  expect_reads<std::uint32_t>("SIZE 4 4 4\nTYPE U U U\n", 4294967295u, 1, 0);
  expect_reads<std::int64_t>("SIZE 8 8 8\nTYPE I I I\n", -9007199254740993, 5, -1);
  expect_reads<std::uint64_t>("SIZE 8 8 8\nTYPE U U U\n", 18446744073709551615u, 1, 0);
}

TEST(PcdFile, reads_compressed_fields_one_behind_another) {
  // All x, then all labels, then all z, then all y; the last run by a reference.
  const std::string layout = "FIELDS x label z y\nSIZE 4 1 4 4\nTYPE F U F F\nCOUNT 1 2 1 1\n";
  const std::string values = raw(1.0F) + raw(2.0F) + "abcd" + raw(3.0F) + raw(4.0F);
  const std::string repeat = {static_cast<char>(6 << 5), 7};  // 8 bytes from 8 back: y as z
  const std::string data = compressed_data(stored(values) + repeat, values.size() + 8);
  EXPECT_TRUE(same_bits(read_text_as_pcd(header(layout, 2, "binary_compressed") + data),
                        std::vector<Vector3f>{{1, 3, 3}, {2, 4, 4}}));
}

TEST(PcdFile, reads_organised_clouds_row_by_row) {
  std::string data;
  for (int i = 0; i < 6; ++i) data += raw(static_cast<float>(i)) + raw(kNan) + raw(0.0F);
  const auto points =
      read_text_as_pcd("# .PCD v0.7\n" + kXyz + "WIDTH 3\nHEIGHT 2\nDATA binary\n" + data);
  ASSERT_EQ(points.size(), 6u);
  EXPECT_EQ(points[5].x(), 5);
}

TEST(PcdFile, may_be_padded_with_zeros) {
  const std::string point = raw(1.0F) + raw(2.0F) + raw(3.0F);
  const std::string binary = header(kXyz, 1, "binary") + point;
  const std::string compressed =
      header(kXyz, 1, "binary_compressed") + compressed_data(stored(point), 12);
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.pcd";
  int cases = 0;
  for (const std::string& text : {binary, compressed}) {
    for (const std::size_t padding : {1u, 3902u, 65536u}) {
      EXPECT_EQ(read_text_as_pcd(text + std::string(padding, '\0')).size(), 1u) << padding;
      ++cases;
    }
    test::write_text(file, text + std::string(65537, '\0'));
    EXPECT_THROW(read_points(file), Error);
    test::write_text(file, text + std::string("\0\0\1", 3));
    EXPECT_THROW(read_points(file), Error);
  }
  EXPECT_EQ(cases, 6);
}

TEST(PcdFile, may_hold_no_points) {
  EXPECT_TRUE(read_text_as_pcd(header(kXyz, 0, "ascii")).empty());
  EXPECT_TRUE(read_text_as_pcd(header(kXyz, 0, "binary")).empty());
  EXPECT_TRUE(read_text_as_pcd(header(kXyz, 0, "binary_compressed")).empty());
  EXPECT_TRUE(
      read_text_as_pcd(header(kXyz, 0, "binary_compressed") + compressed_data("", 0)).empty());
  const test::TemporaryFolder folder;
  write_points(folder / "a.pcd", {});
  EXPECT_TRUE(read_points(folder / "a.pcd").empty());
}

TEST(PcdFile, gives_back_the_bits_that_were_written) {
  const test::TemporaryFolder folder;
  write_points(folder / "a.pcd", test::nasty_points());
  EXPECT_TRUE(same_bits(read_points(folder / "a.pcd"), test::nasty_points()));
  std::vector<Vector3f> many(30000);
  test::Random random(7);
  SCOPED_TRACE(random.trace());
  for (Vector3f& point : many) point = random.point(-100, 100).cast<float>();
  write_points(folder / "a.pcd", many);
  EXPECT_TRUE(same_bits(read_points(folder / "a.pcd"), many));
}

TEST(PcdFile, has_a_header_of_one_length_for_all_counts) {
  const std::size_t size = pcd_header_text({"x", "y"}, 0).size();
  for (const std::uint64_t count :
       {std::uint64_t{9}, std::uint64_t{123456}, std::numeric_limits<std::uint64_t>::max()}) {
    EXPECT_EQ(pcd_header_text({"x", "y"}, count).size(), size) << count;
  }
}

struct BadFile {
  std::string text;
  std::string problem;  // behind the file's name
};

TEST(PcdFile, names_what_is_wrong_with_the_data) {
  const std::string point = raw(1.0F) + raw(2.0F) + raw(3.0F);
  const std::string packed = compressed_data(stored(point), 12);
  const std::string binary = header(kXyz, 2, "binary");
  const std::string compressed = header(kXyz, 1, "binary_compressed");
  const std::size_t behind = compressed.size() + 8;  // offset of the compressed bytes
  const std::vector<BadFile> cases = {
      {"", " is no sound PCD file: the header has no DATA"},
      {binary + point, " announces 2 points of 12 bytes each and holds 12 bytes of data"},
      {binary + point + point + "x",
       " announces 2 points of 12 bytes each and holds 25 bytes of data"},
      {header(kXyz, 2, "ascii") + "1 2 3\n",
       " announces 2 points of 3 numbers each, for which its 6 bytes of data have no room"},
      {header(kXyz, 2, "ascii") + "1 2 3           \n",
       " is cut off: it announces 2 points and holds 1"},
      {header(kXyz, 1, "ascii") + "1 2 3\n4 5 6\n",
       ", line 11: the data go on behind the 1 points that are announced"},
      {header(kXyz, 1, "ascii") + "1 2 garbage\n",
       ", line 10: z is \"garbage\", which must be a number"},
      {header(kXyz, 1, "ascii") + "1 2,0 3\n", ", line 10: y is \"2,0\", which must be a number"},
      {header(kXyz, 2, "ascii") + "1 2 3 4\n1 2 3\n",
       ", line 10: the point has 4 numbers, which must be 3 as the header says"},
      {header(kXyz, 1, "ascii") + "1 2     \n",
       ", line 10: the point has 2 numbers, which must be 3 as the header says"},
      {compressed, fmt::format(" is cut off: the size of the compressed data at byte {} takes 4 "
                               "bytes, and 0 are left",
                               behind - 8)},
      {compressed + packed.substr(0, 6),
       fmt::format(" is cut off: the size of the data at byte {} takes 4 bytes, and 2 are left",
                   behind - 4)},
      {compressed + packed.substr(0, 15),
       fmt::format(" announces 13 compressed bytes from byte {} on and holds 7", behind)},
      {compressed + packed + "more",
       fmt::format(" announces 13 compressed bytes from byte {} on and holds 17", behind)},
      {compressed + compressed_data(stored(point), 24),
       " announces 1 points of 12 bytes each and holds 24 bytes of data"},
      {compressed + compressed_data(stored(point + "x"), 12),
       fmt::format(" is damaged: the 14 compressed bytes that end at byte {} must give 12 bytes "
                   "and do not",
                   behind + 14)},
      {compressed + compressed_data("\xff\xff\xff", 12),
       fmt::format(" is damaged: the 3 compressed bytes that end at byte {} must give 12 bytes "
                   "and do not",
                   behind + 3)}};
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.pcd";
  for (const BadFile& bad : cases) {
    test::write_text(file, bad.text);
    expect_error(ErrorKind::input, file + bad.problem, [&] { read_points(file); });
  }
  EXPECT_EQ(cases.size(), 17u);
}

TEST(PcdFile, refuses_large_announcements_before_taking_memory) {
  const std::string filler(500, '1');
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.pcd";
  int cases = 0;
  for (const std::uint64_t points :
       {std::uint64_t{10'000'000}, std::uint64_t{1} << 40, most / 12, most / 12 + 42, most}) {
    test::write_text(file, header(kXyz, points, "ascii") + filler);
    expect_error(ErrorKind::input,
                 fmt::format("{} announces {} points of 3 numbers each, for which its 500 bytes of "
                             "data have no room",
                             file, points),
                 [&] { read_points(file); });
    test::write_text(file, header(kXyz, points, "binary") + filler);
    expect_error(ErrorKind::input,
                 fmt::format("{} announces {} points of 12 bytes each and holds 500 bytes of data",
                             file, points),
                 [&] { read_points(file); });
    cases += 2;
  }
  // Compressed bytes can become 88 times as many and not more.
  const std::string text = header(kXyz, 300'000'000, "binary_compressed");
  test::write_text(file, text + compressed_data(filler, 3'600'000'000));
  expect_error(ErrorKind::input,
               fmt::format("{} is damaged: the 500 compressed bytes that end at byte {} must give "
                           "3600000000 bytes and do not",
                           file, text.size() + 508),
               [&] { read_points(file); });
  EXPECT_EQ(cases, 10);
}

}  // namespace
}  // namespace rmap
