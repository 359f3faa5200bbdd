#include "io/ply_file.hpp"

#include "io/files.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::raw;
using test::same_bits;
using test::write_text;

const std::vector<Vector3f> kPoints = {{1, 2, 3}, {-4, 0.5F, 1e-3F}};

std::string turned(std::string bytes) {
  std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

// A face with a list before the vertices, whose properties are of all sizes.
std::string binary(bool big) {
  std::string text = fmt::format(
      "ply\nformat binary_{}_endian 1.0\ncomment x\nobj_info y\nelement face 2\n"
      "property list uchar int vertex_indices\nproperty short mark\nelement nothing 7\n"
      "element vertex 2\nproperty uchar red\nproperty double z\nproperty float y\n"
      "property int16 ring\nproperty float32 x\nelement edge 1\nproperty uint a\nend_header\n",
      big ? "big" : "little");
  const auto put = [&](auto number) { text += big ? turned(raw(number)) : raw(number); };
  for (const int corners : {3, 0}) {
    put(static_cast<std::uint8_t>(corners));
    for (int i = 0; i < corners; ++i) put(std::int32_t{i});
    put(std::int16_t{-1});
  }
  for (const Vector3f& point : kPoints) {
    put(std::uint8_t{200});
    put(static_cast<double>(point.z()));
    put(point.y());
    put(std::int16_t{12});
    put(point.x());
  }
  put(std::uint32_t{9});
  return text;
}

TEST(PlyFile, reads_both_orders_of_bytes) {
  const test::TemporaryFolder folder;
  for (const bool big : {false, true}) {
    write_text(folder / "a.ply", binary(big));
    EXPECT_TRUE(same_bits(read_points(folder / "a.ply"), kPoints)) << big;
  }
}

TEST(PlyFile, reads_text_with_properties_in_any_order) {
  const test::TemporaryFolder folder;
  write_text(folder / "a.ply",
             "ply\r\nformat ascii 1.0\nelement face 1\nproperty list uchar int i\n"
             "element vertex 2\nproperty float z\nproperty float quality\nproperty float X\n"
             "property float y\nend_header\n3 0 1 2\n\n3 9 1 2\n0.001 9 -4 .5\n\n");
  EXPECT_TRUE(same_bits(read_points(folder / "a.ply"), kPoints));
}

TEST(PlyFile, reads_where_each_beam_began) {
  const test::TemporaryFolder folder;
  write_text(folder / "a.ply",
             "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
             "property float z\nproperty double origin_x\nproperty double origin_y\n"
             "property double origin_z\nend_header\n5 6 7 1.5 2.5 3.5\n");
  const auto source = open_scans(folder / "a.ply", {.offset = {1, 0, 0}});
  Scan scan;
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.frame, Frame::map);
  EXPECT_EQ(scan.points.at(0), Vector3f(4, 6, 7));
  EXPECT_EQ(scan.origins.at(0), Vector3d(0.5, 2.5, 3.5));
}

TEST(PlyFile, notices_every_cut_of_binary_data) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.ply";
  const std::string whole = binary(false);
  std::size_t cuts = 0;
  for (std::size_t size = 0; size < whole.size(); ++size, ++cuts) {
    write_text(file, whole.substr(0, size));
    EXPECT_THROW(read_points(file), Error) << size;
  }
  EXPECT_EQ(cuts, whole.size());
  write_text(file, whole + "x");
  expect_error(ErrorKind::input,
               file + " is no sound PLY file: 1 bytes are left over behind its last element",
               [&] { read_points(file); });
}

std::string header(const std::string& lines) {
  return "ply\nformat binary_little_endian 1.0\n" + lines + "end_header\n";
}

TEST(PlyFile, says_what_is_wrong) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.ply";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  const std::string sound = file + " is no sound PLY file: ";
  struct Case {
    std::string text;
    std::string sentence;
  };
  const std::vector<Case> cases = {
      {"plx\n", file + ", line 1: a PLY file begins with the line ply"},
      {"ply\nformat ascii 1.1\n",
       file + ", line 2: the version of the format is \"1.1\", where 1.0 is allowed"},
      {"ply\nelement vertex -1\n",
       file + ", line 2: the number of elements \"vertex\" is \"-1\", which must be a whole number "
              "from 0 to 2^64 - 1"},
      {"ply\nproperty float x\n", file + ", line 2: a property stands before the first element"},
      {"ply\nformat ascii 1.0\n", file + ", line 2: the header has no line end_header"},
      {header("element face 1\nproperty int x\n"), sound + "its header has no element vertex"},
      {header("element vertex 1\nproperty float x\n"),
       sound + "the properties of its vertices must have x, y and z once each"},
      {header("element vertex 1\nproperty list uchar int x\n" + xyz),
       sound + "its element vertex has a list, where single values are allowed"},
      {header("element vertex 10000000\n" + xyz),
       sound + "it announces 10000000 elements \"vertex\" and its 0 bytes of data end before"},
      {header("element vertex 18446744073709551615\n" + xyz),
       file + " holds 18446744073709551615 points: 268435456 are allowed in a file"},
      {header("element face 1\nproperty list char int i\nelement vertex 0\n" + xyz) + "\xff",
       sound + "it has a list of negative size"}};
  for (const Case& one : cases) {
    write_text(file, one.text);
    expect_error(
        one.sentence.find("holds 18") == std::string::npos ? ErrorKind::input : ErrorKind::limit,
        one.sentence, [&] { read_points(file); });
  }
  EXPECT_EQ(cases.size(), 11u);
}

TEST(PlyFile, gives_up_soon_on_elements_without_end) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.ply";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  for (const std::string many : {"element nothing 18446744073709551615\n",
                                 "element face 18446744073709551615\nproperty list uchar int i\n",
                                 "element face 18446744073709551615\nproperty list uint64 int i\n",
                                 "element face 1000\nproperty list uint double i\n"}) {
    for (const std::string form : {"ascii", "binary_big_endian"}) {
      write_text(file, "ply\nformat " + form + " 1.0\n" + many + "element vertex 1\n" + xyz +
                           "end_header\n" + std::string(1000, '\xff'));
      EXPECT_THROW(read_points(file), Error) << many;
    }
  }
}

}  // namespace
}  // namespace rmap
