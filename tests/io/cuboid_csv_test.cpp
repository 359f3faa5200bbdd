#include "io/cuboid_samples.hpp"
#include "io/files.hpp"

#include <gtest/gtest.h>

#include <rmap/cuboid_files.hpp>

namespace rmap {
namespace {

const std::string kComment =
    "# rmap cuboids; resolution 0.1 m; frame, from the input to the cells, 3x4 by rows: ";
const std::string kStart = kComment + "1 0 0 1.5 0 0.8 -0.6 -2.25 0 0.6 0.8 0.1\n" +
                           "min_x,min_y,min_z,max_x,max_y,max_z,points,density\n";

TEST(CuboidCsv, is_what_the_docs_say) {
  EXPECT_EQ(test::written(".csv", test::small_list()),
            kStart +
                "-1,0,0.30000000000000004,2,0.5,0.4,75,0.5\n"
                "0.7000000000000001,-0.1,0,0.8,0,0.1,0,0\n");
}

class CuboidCsvErrors : public testing::Test {
 protected:
  void expect_refused(const std::string& text, const std::string& problem) {
    const auto file = folder_ / "a.csv";
    test::write_text(file, text);
    test::expect_error(ErrorKind::input, file.string() + ", " + problem,
                       [&] { read_cuboids(file); });
    ++cases_;
  }
  void expect_row_refused(const std::string& row, const std::string& problem) {
    expect_refused(kStart + "0,0,0,1,1,1,500,0.5\n" + row + "\n", "line 4: " + problem);
  }

  const test::TemporaryFolder folder_;
  int cases_ = 0;
};

TEST_F(CuboidCsvErrors, of_the_first_lines) {
  const std::string begin =
      "line 1: a file of cuboids must begin with \"# rmap cuboids; resolution \"";
  expect_refused("x,y,z\n1,2,3\n", begin);
  expect_refused("\n", begin);
  expect_refused("# rmap cuboids; resolution x m;\n",
                 "line 1: the resolution is \"x m;\", no finite number");
  expect_refused("# rmap cuboids; resolution nan" + kComment.substr(30),
                 "line 1: the resolution is \"nan\", no finite number");
  expect_refused(
      "# rmap cuboids; resolution -1" + kComment.substr(30) + "1 0 0 0 0 1 0 0 0 0 1 0\n",
      "line 1: resolution is -1 m: it must lie in 1e-06 to 1000000 m");
  expect_refused(kComment + "1 0 0 0 0 1 0 0 0 0 1\n",
                 "line 1: the frame is \"\", no finite number");
  expect_refused(kComment + "1 0 0 0 0 1 0 inf 0 0 1 0\n",
                 "line 1: the frame is \"inf\", no finite number");
  expect_refused(
      kComment + "-1 0 0 0 0 1 0 0 0 0 1 0\n",
      "line 1: the 3x3 part of the pose is no rotation but a reflection: its determinant "
      "is -1");
  expect_refused(kComment + "1 0 0 0 0 1 0 0 0 0 1 0 0\n", "line 1: \"0\" follows the frame");
  const std::string header =
      "line 2: the header must be min_x,min_y,min_z,max_x,max_y,max_z,points,density";
  expect_refused(kComment + "1 0 0 0 0 1 0 0 0 0 1 0\nx,y\n", header);
  EXPECT_EQ(cases_, 10);
}

TEST_F(CuboidCsvErrors, of_an_empty_file) {
  expect_refused("", "line 1: a file of cuboids must begin with \"# rmap cuboids; resolution \"");
  expect_refused(kComment + "1 0 0 0 0 1 0 0 0 0 1 0",
                 "line 2: the header must be min_x,min_y,min_z,max_x,max_y,max_z,points,density");
}

TEST_F(CuboidCsvErrors, of_rows) {
  expect_row_refused("", "the line has 1 fields, which must be 8");
  expect_row_refused("0,0,0,1,1,1,500", "the line has 7 fields, which must be 8");
  expect_row_refused("0,0,0,1,1,1,500,0.5,", "the line has 9 fields, which must be 8");
  expect_row_refused("0,0,0,1,nan,1,500,0.5", "max_y is \"nan\", no finite number");
  expect_row_refused("0,,0,1,1,1,500,0.5", "min_y is \"\", no finite number");
  expect_row_refused("0, 0,0,1,1,1,500,0.5", "min_y is \" 0\", no finite number");
  expect_row_refused("0,0,-inf,1,1,1,500,0.5", "min_z is \"-inf\", no finite number");
  expect_row_refused("0,0,0,1,1,1e999,500,0.5", "max_z is \"1e999\", no finite number");
  expect_row_refused("0.05,0,0,1,1,1,500,0.5",
                     "min_x is 0.05 m, which is no border of cells of 0.1 m");
  expect_row_refused("0,0,0,1.0000002,1,1,500,0.5",
                     "max_x is 1.0000002 m, which is no border of cells of 0.1 m");
  expect_row_refused("0,0,0,107374182.5,1,1,0,0",
                     "max_x is 107374182.5 m, which is beyond the limits of cell indices");
  expect_row_refused("0,0,-1e300,1,1,1,0,0",
                     "min_z is -1e300 m, which is beyond the limits of cell indices");
  expect_row_refused("0,1,0,1,1,1,500,0.5", "min_y is 1, which must be less than max_y, 1");
  expect_row_refused("0,0,3,1,1,1,500,0.5", "min_z is 3, which must be less than max_z, 1");
  expect_row_refused("0,0,0,1,1,1,-1,0.5", "points is \"-1\", no count");
  expect_row_refused("0,0,0,1,1,1,1.5,0.5", "points is \"1.5\", no count");
  expect_row_refused("0,0,0,1,1,1,18446744073709551616,0.5",
                     "points is \"18446744073709551616\", no count");
  for (const std::string density : {"nan", "", "0.51", "0.", "-0.5", "0.5x"}) {
    expect_row_refused("0,0,0,1,1,1,500," + density,
                       "density is \"" + density + "\", where points by volume in cells is 0.5");
  }
  EXPECT_EQ(cases_, 23);
}

TEST(CuboidCsv, takes_lines_of_other_systems_and_snaps_to_the_lattice) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.csv", kComment +
                                         "1 0 0 0 0 1 0 0 0 0 1 0\r\n"
                                         "min_x,min_y,min_z,max_x,max_y,max_z,points,density\r\n"
                                         "0,0,0.3,0.99999999,1,0.4,10,0.1");
  const CuboidList list = read_cuboids(folder / "a.csv");
  ASSERT_EQ(list.cuboids.size(), 1U);
  EXPECT_EQ(list.cuboids[0],
            (Cuboid{.cells = {.min = {0, 0, 3}, .max = {10, 10, 4}}, .points = 10}));
}

TEST(CuboidCsv, is_refused_wherever_it_is_cut_within_a_line) {
  const test::TemporaryFolder folder;
  const std::string text = test::written(".csv", test::small_list());
  int refused = 0;
  int read = 0;
  for (std::size_t size = 0; size < text.size(); ++size) {
    test::write_text(folder / "a.csv", text.substr(0, size));
    try {
      const CuboidList list = read_cuboids(folder / "a.csv");
      // At the end of a line, with or without its end: a shorter list.
      const CuboidList whole = test::small_list();
      ASSERT_LE(list.cuboids.size(), whole.cuboids.size());
      for (std::size_t i = 0; i < list.cuboids.size(); ++i) {
        EXPECT_EQ(list.cuboids[i], whole.cuboids[i]) << size;
      }
      ++read;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      ++refused;
    }
  }
  EXPECT_EQ(read, 5);
  EXPECT_EQ(refused + read, static_cast<int>(text.size()));
}

}  // namespace
}  // namespace rmap
