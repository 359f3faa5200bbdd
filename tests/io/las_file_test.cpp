#include "io/las_file.hpp"

#include "io/files.hpp"
#include "io/scan_samples.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::Las;
using test::raw;
using test::same_bits;
using test::write_text;

TEST(LasFile, scales_and_shifts_in_double) {
  const test::TemporaryFolder folder;
  std::vector<Las> files = {
      {}, {.minor = 3, .format = 3, .point_size = 34}, {.minor = 4, .format = 6, .point_size = 31}};
  for (const Las& las : files) {
    write_text(folder / "a.las", las.bytes());
    EXPECT_TRUE(
        same_bits(read_points(folder / "a.las"),
                  std::vector<Vector3f>{{static_cast<float>(1 * 0.01 + 1000), -1999, 0.003F},
                                        {996, -2000, static_cast<float>((1 << 30) * 1e-3)}}));
    EXPECT_TRUE(
        same_bits(read_points(folder / "a.las", {.offset = {1000, -1999, 0}}),
                  std::vector<Vector3f>{{static_cast<float>(1 * 0.01 + 1000 - 1000), 0, 0.003F},
                                        {-4, -1, static_cast<float>((1 << 30) * 1e-3)}}));
  }
  EXPECT_EQ(files.size(), 3u);
}

TEST(LasFile, reads_more_points_than_fit_in_a_piece) {
  const test::TemporaryFolder folder;
  Las las{.scale = {1, 1, 1}, .offset = {0, 0, 0}};
  las.points.clear();
  for (int i = 0; i < 40'000; ++i) las.points.push_back({i, -i, 2 * i});
  write_text(folder / "a.las", las.bytes());
  const std::vector<Vector3f> points = read_points(folder / "a.las");
  ASSERT_EQ(points.size(), 40'000u);
  for (int i = 0; i < 40'000; ++i) {
    const auto x = static_cast<float>(i);
    ASSERT_EQ(points[static_cast<std::size_t>(i)], Vector3f(x, -x, 2 * x));
  }
}

TEST(LasFile, takes_no_memory_on_the_word_of_a_file) {
  const test::TemporaryFolder folder;
  // Points of the largest size, of which there is none.
  Las las{.point_size = 65535};
  las.points.clear();
  write_text(folder / "a.las", las.bytes());
  EXPECT_TRUE(read_points(folder / "a.las").empty());
  las.points.assign(9, {1, 2, 3});
  write_text(folder / "a.las", las.bytes());
  EXPECT_EQ(read_points(folder / "a.las").size(), 9u);
}

TEST(LasFile, says_how_to_unpack_what_is_packed) {
  const test::TemporaryFolder folder;
  for (const std::string ending : {".las", ".laz"}) {
    const std::string file = folder / ("a" + ending);
    write_text(file, Las{.format = 0x80}.bytes());
    expect_error(ErrorKind::input,
                 file +
                     " is packed (LAZ): unpack it, with `laszip -i IN.laz -o OUT.las` or `pdal "
                     "translate IN.laz OUT.las`, and read that",
                 [&] { read_points(file); });
  }
}

TEST(LasFile, says_what_is_wrong) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.las";
  const std::string sound = file + " is no sound LAS file: ";
  const std::string whole = Las().bytes();
  struct Case {
    std::string bytes;
    std::string sentence;
  };
  std::string late = whole;
  late.replace(96, 4, raw(std::uint32_t{1'000'000}));
  std::string many = whole;
  many.replace(107, 4, raw(std::uint32_t{10'000'000}));
  const std::vector<Case> cases = {
      {"", "it does not begin with LASF"},
      {whole.substr(0, 100), "its header has 100 bytes, where 227 are the least"},
      {Las{.minor = 1}.bytes(), "its version is 1.1, where 1.2 to 1.4 are allowed"},
      {Las{.format = 11}.bytes(), "its points have format 11, where 0 to 10 are allowed"},
      {Las{.format = 3}.bytes(), "its points of format 3 have 20 bytes, where 34 are the least"},
      {Las{.scale = {1, 0, 1}}.bytes(),
       "its scale factors must be above zero and its offsets finite"},
      {late, "its points are said to begin at byte 1000000 of 274, behind a header of 227"},
      {many, "it announces 10000000 points of 20 bytes each and holds 40 bytes of data"},
      {whole.substr(0, whole.size() - 1),
       "it announces 2 points of 20 bytes each and holds 39 bytes of data"}};
  for (const Case& one : cases) {
    write_text(file, one.bytes);
    expect_error(ErrorKind::input, sound + one.sentence, [&] { read_points(file); });
  }
  EXPECT_EQ(cases.size(), 9u);
}

}  // namespace
}  // namespace rmap
