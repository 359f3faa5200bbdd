#include "io/text_points.hpp"

#include "io/files.hpp"

#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::same_bits;
using test::write_text;

TEST(TextPoints, takes_separators_headers_and_comments_as_they_come) {
  const test::TemporaryFolder folder;
  const std::vector<Vector3f> expected = {{1, 2, 3}, {-4.5F, 0, 1e-3F}};
  const std::vector<std::string> texts = {
      "1 2 3\n-4.5 0 0.001\n",
      "1\t2\t3\r\n-4.5\t0\t1e-3",
      "1,2,3\n-4.5,0,1e-3\n",
      "1 , 2 , 3 ,\n -4.5 , 0 , 1e-3 ,\n",
      "1;2;3\n-4.5;0;1e-3\n",
      "# text\n\n1 2 3 99 98 // more\n-4.5 0 +1e-3 97 96\n",
      "// x y z\n1 2 3\n-4.5 0 1e-3\n",
      "x,y,z\n1,2,3\n-4.5,0,1e-3\n",
      "\"intensity\", \"Z\", \"X\", \"Y\"\n7, 3, 1, 2\n7, 1e-3, -4.5, 0\n",
      "time x name y z\n1 1 a 2 3\n2 -4.5 b 0 1e-3\n",
      "2\n1 2 3\n-4.5 0 1e-3\n",
      "\xEF\xBB\xBFx y z\n1 2 3\n-4.5 0 1e-3\n",
      "# z x y\n# more\n3 1 2\n1e-3 -4.5 0\n",
      "//Z,X,Y\n3,1,2\n1e-3,-4.5,0\n",
      "# z x y i\n1 2 3\n-4.5 0 1e-3\n",
      "x,y,z\n1,2,3,\n-4.5,0,1e-3,\n",
      "x;y;z;empty\n1;2;3;\n-4.5;0;1e-3;\n"};
  std::size_t cases = 0;
  for (const std::string& text : texts) {
    for (const char* const name : {"a.xyz", "a.csv", "a.txt", "a.dat"}) {
      write_text(folder / name, text);
      ASSERT_TRUE(same_bits(read_points(folder / name), expected)) << text;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 4 * texts.size());
}

TEST(TextPoints, keeps_what_is_not_finite) {
  const test::TemporaryFolder folder;
  write_text(folder / "a.xyz", "nan inf -inf\n1 2 1e300\n");
  const auto points = read_points(folder / "a.xyz");
  EXPECT_TRUE(std::isnan(points.at(0).x()));
  EXPECT_TRUE(std::isinf(points.at(1).z()));
}

TEST(TextPoints, reads_where_each_beam_began) {
  const test::TemporaryFolder folder;
  write_text(folder / "a.csv", "sensor_x,sensor_y,sensor_z,x,y,z\n0.1,0.2,0.3,1,2,3\n");
  const auto source = open_scans(folder / "a.csv", {.offset = {0.1, 0, 0}});
  Scan scan;
  ASSERT_TRUE(source->next(scan));
  EXPECT_EQ(scan.frame, Frame::map);
  EXPECT_EQ(scan.origins.at(0), Vector3d(0, 0.2, 0.3));
  EXPECT_EQ(scan.points.at(0), Vector3f(0.9F, 2, 3));
}

TEST(TextPoints, says_what_is_wrong) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.xyz";
  struct Case {
    std::string text;
    std::string sentence;
  };
  const std::vector<Case> cases = {
      {"", " holds no point: a text of points has a line of at least three numbers for each"},
      {"1 2 3\n4 5\n", ", line 2: the point has 2 numbers, which must be at least three"},
      {"1 2 3\n4 5 6 7\n",
       ", line 2: the point has 4 columns, which must be 3 as in the lines before"},
      {"1 2 3\n4 x 6\n", ", line 2: y is \"x\", which must be a number"},
      {"1,5;2,5;3,5\n",
       ", line 1: \"1,5 2,5 3,5\" are neither a point nor the names of columns, among which must "
       "be "
       "x, y and z once each"},
      {"3\n1 2 3\n", " announces 3 points in its first line and holds 1"},
      {"MAPNODEID a\n",
       " is a collection of OctoMap maps, not points: its maps are read one by one"}};
  for (const Case& one : cases) {
    write_text(file, one.text);
    expect_error(ErrorKind::input, file + one.sentence, [&] { read_points(file); });
  }
  EXPECT_EQ(cases.size(), 7u);
}

}  // namespace
}  // namespace rmap
