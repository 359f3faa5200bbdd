#include "io/files.hpp"
#include "support/random.hpp"

#include <cstring>
#include <stdexcept>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/cell_files.hpp>
#include <rmap/scan_files.hpp>

namespace rmap {
namespace {

using test::expect_error;

std::vector<CellRow> random_rows(test::Random& random, int count) {
  std::vector<CellRow> rows(static_cast<std::size_t>(count));
  for (CellRow& row : rows) {
    row = {.center = random.point(-1000, 1000),
           .size = 0.1 * random.integer(1, 8),
           .probability = random.real(0, 1),
           .occupied = random.chance(0.5)};
  }
  return rows;
}

std::uint64_t write_rows(const std::filesystem::path& file, const std::vector<CellRow>& rows) {
  return write_cells(file, [&](CellSink sink) {
    for (const CellRow& row : rows) sink(row);
  });
}

TEST(CellFiles, csv_is_what_the_docs_say) {
  const test::TemporaryFolder folder;
  const std::vector<CellRow> rows = {
      {.center = {0.05, -1.25, 3}, .size = 0.1, .probability = 0.7, .occupied = true},
      {.center = {0.1 + 0.2, 1e-9, 1e20}, .size = 0.2, .probability = 0.1192, .occupied = false}};
  EXPECT_EQ(write_rows(folder / "a.csv", rows), 2u);
  EXPECT_EQ(test::read_text(folder / "a.csv"),
            "x,y,z,size,probability,state\n"
            "0.05,-1.25,3,0.1,0.7,occupied\n"
            "0.30000000000000004,1e-09,1e+20,0.2,0.1192,free\n");
}

TEST(CellFiles, csv_gives_the_same_doubles_back) {
  test::Random random(11);
  SCOPED_TRACE(random.trace());
  const test::TemporaryFolder folder;
  const auto rows = random_rows(random, 1000);
  EXPECT_EQ(write_rows(folder / "a.csv", rows), 1000u);
  std::istringstream text(test::read_text(folder / "a.csv"));
  std::string line;
  std::getline(text, line);
  for (const CellRow& row : rows) {
    std::getline(text, line);
    double x = 0, y = 0, z = 0, size = 0, probability = 0;
    char state[16] = "";
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,%lf,%15s", &x, &y, &z, &size, &probability,
                          state),
              6);
    ASSERT_EQ(Vector3d(x, y, z), row.center);
    ASSERT_EQ(size, row.size);
    ASSERT_EQ(probability, row.probability);
    ASSERT_STREQ(state, row.occupied ? "occupied" : "free");
  }
  EXPECT_FALSE(std::getline(text, line));
}

TEST(CellFiles, ply_holds_floats_and_state) {
  test::Random random(12);
  SCOPED_TRACE(random.trace());
  const test::TemporaryFolder folder;
  for (const int count : {0, 1, 9, 10, 12345}) {
    const auto rows = random_rows(random, count);
    write_rows(folder / "a.ply", rows);
    const std::string text = test::read_text(folder / "a.ply");
    const std::string end = "end_header\n";
    const std::size_t header = text.find(end) + end.size();
    EXPECT_TRUE(text.starts_with("ply\nformat binary_little_endian 1.0\ncomment "));
    EXPECT_THAT(text.substr(0, header),
                testing::HasSubstr(fmt::format(
                    "\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
                    "property float probability\nproperty uchar state\n",
                    count)));
    std::string expected;
    for (const CellRow& row : rows) {
      const Vector3f center = row.center.cast<float>();
      expected += test::raw(center.x()) + test::raw(center.y()) + test::raw(center.z()) +
                  test::raw(static_cast<float>(row.probability)) + (row.occupied ? '\1' : '\0');
    }
    EXPECT_TRUE(text.substr(header) == expected) << count;
  }
}

TEST(CellFiles, pcd_is_read_as_a_cloud) {
  test::Random random(13);
  SCOPED_TRACE(random.trace());
  const test::TemporaryFolder folder;
  for (const int count : {0, 1, 9, 10, 12345}) {
    const auto rows = random_rows(random, count);
    write_rows(folder / "a.pcd", rows);
    std::vector<Vector3f> expected;
    for (const CellRow& row : rows) expected.push_back(row.center.cast<float>());
    EXPECT_TRUE(test::same_bits(read_points(folder / "a.pcd"), expected)) << count;
  }
  EXPECT_THAT(test::read_text(folder / "a.pcd"),
              testing::HasSubstr("FIELDS x y z probability\nSIZE 4 4 4 4\nTYPE F F F F\n"));
}

TEST(CellFiles, are_not_written_when_the_cells_fail) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.csv", "old");
  EXPECT_THROW(write_cells(folder / "a.csv",
                           [](CellSink sink) {
                             sink({});
                             throw std::runtime_error("stopped");
                           }),
               std::runtime_error);
  EXPECT_EQ(test::read_text(folder / "a.csv"), "old");
  EXPECT_THAT(folder.names(), testing::ElementsAre("a.csv"));
}

TEST(CellFiles, refuses_other_endings_before_asking_for_cells) {
  expect_error(ErrorKind::input,
               "the ending of cells.las is \".las\", where .csv, .ply and .pcd are allowed",
               [] { write_cells("cells.las", [](CellSink) { FAIL(); }); });
}

}  // namespace
}  // namespace rmap
