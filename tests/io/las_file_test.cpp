#include "io/las_file.hpp"

#include "io/files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::raw;
using test::same_bits;
using test::write_text;

struct Las {
  int minor = 2;
  int format = 0;
  std::uint16_t point_size = 20;
  std::vector<std::array<std::int32_t, 3>> points = {{{1, 2, 3}}, {{-400, 0, 1 << 30}}};
  Vector3d scale = {0.01, 0.5, 1e-3};
  Vector3d offset = {1000, -2000, 0};

  std::string bytes() const {
    const std::size_t header_size = minor == 4 ? 375 : 227;
    std::string text(header_size, '\0');
    const auto put = [&](std::size_t at, const std::string& value) {
      text.replace(at, value.size(), value);
    };
    put(0, "LASF");
    put(24, std::string(1, '\1') + static_cast<char>(minor));
    put(94, raw(static_cast<std::uint16_t>(header_size)));
    put(96, raw(static_cast<std::uint32_t>(header_size + 7)));  // some bytes of a record between
    put(104, std::string(1, static_cast<char>(format)));
    put(105, raw(point_size));
    if (minor == 4) {
      put(247, raw(static_cast<std::uint64_t>(points.size())));
    } else {
      put(107, raw(static_cast<std::uint32_t>(points.size())));
    }
    for (int axis = 0; axis < 3; ++axis) {
      const auto place = static_cast<std::size_t>(8 * axis);
      put(131 + place, raw(scale[axis]));
      put(155 + place, raw(offset[axis]));
    }
    text += "records";
    for (const auto& point : points) {
      for (const std::int32_t value : point) text += raw(value);
      text += std::string(point_size - 12u, '\x55');
    }
    return text;
  }
};

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
