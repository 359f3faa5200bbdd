#include "io/cuboid_samples.hpp"
#include "io/files.hpp"

#include <cstdlib>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/cuboid_files.hpp>

namespace rmap {
namespace {

using test::expect_error;

constexpr std::array kEndings = {".rcs",  ".csv", ".json", ".ply",  ".glb",
                                 ".urdf", ".sdf", ".xml",  ".scene"};

TEST(CuboidFiles, come_back_from_both_formats_that_are_read) {
  test::Random random(21);
  SCOPED_TRACE(random.trace());
  const test::TemporaryFolder folder;
  int cases = 0;
  for (const int count : {0, 1, 2, 3, 10, 100, 1000, 20000}) {
    for (const char* ending : {".rcs", ".csv"}) {
      const CuboidList list = test::random_cuboids(random, count);
      const auto file = folder / (std::string("a") + ending);
      write_cuboids(file, list);
      EXPECT_TRUE(test::same(read_cuboids(file), list)) << count << ending;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 16);
}

TEST(CuboidFiles, come_back_at_every_resolution) {
  test::Random random(22);
  SCOPED_TRACE(random.trace());
  const test::TemporaryFolder folder;
  int cases = 0;
  for (const double resolution : {1e-6, 0.001, 0.05, 0.1, 1.0 / 3, 1e6}) {
    CuboidList list = test::random_cuboids(random, 2000);
    list.resolution = resolution;
    for (Cuboid& cuboid : list.cuboids) {
      // Near the limits, where metres have the fewest digits for a cell.
      cuboid.cells = random.chance(0.5) ? random.box(kMinCellIndex, kMinCellIndex + 1000, 1 << 29)
                                        : random.box(kMaxCellIndex - 1000, kMaxCellIndex, 1);
    }
    for (const char* name : {"a.rcs", "a.csv"}) {
      write_cuboids(folder / name, list);
      EXPECT_TRUE(test::same(read_cuboids(folder / name), list)) << resolution << name;
      ++cases;
    }
  }
  EXPECT_EQ(cases, 12);
}

TEST(CuboidFiles, may_be_empty_and_have_any_name) {
  const test::TemporaryFolder folder;
  int cases = 0;
  for (const std::string ending : kEndings) {
    for (const std::string name : {"a", "with blank", "{} \"<&>\"%s", "\xC3\xA4\n\xFF", "a.csv"}) {
      const auto file = folder / (name + ending);
      write_cuboids(file, {});
      EXPECT_GT(std::filesystem::file_size(file), 10U) << file;
      std::filesystem::remove(file);
      write_cuboids(file, test::small_list());
      if (ending == ".rcs" || ending == ".csv") {
        EXPECT_TRUE(test::same(read_cuboids(file), test::small_list())) << file;
      }
      ++cases;
    }
  }
  EXPECT_EQ(cases, 45);
}

TEST(CuboidFiles, have_known_endings) {
  const test::TemporaryFolder folder;
  expect_error(ErrorKind::input,
               "the ending of a.stl is \".stl\", where .rcs, .csv, .json, .ply, .glb, .urdf, .sdf, "
               ".xml and .scene are allowed",
               [] { write_cuboids("a.stl", {}); });
  for (const std::string ending : {".json", ".ply", ""}) {
    expect_error(
        ErrorKind::input,
        fmt::format("the ending of a{0} is \"{0}\", where .rcs and .csv are allowed", ending),
        [&] { read_cuboids("a" + ending); });
  }
  for (const std::string ending : {".rcs", ".csv"}) {
    const auto file = folder / ("none" + ending);
    expect_error(ErrorKind::io, "cannot open " + file.string() + ": No such file or directory",
                 [&] { read_cuboids(file); });
  }
}

TEST(CuboidFiles, are_not_written_when_the_list_is_none) {
  const test::TemporaryFolder folder;
  int cases = 0;
  const auto refuse = [&](const CuboidList& list, const std::string& sentence) {
    for (const std::string ending : kEndings) {
      const auto file = folder / ("a" + ending);
      test::write_text(file, "old");
      expect_error(ErrorKind::input, sentence, [&] { write_cuboids(file, list); });
      EXPECT_EQ(test::read_text(file), "old");
      ++cases;
    }
  };
  const auto changed = [](auto&& change) {
    CuboidList list = test::small_list();
    change(list);
    return list;
  };
  refuse(changed([](CuboidList& list) { list.resolution = 0; }),
         "resolution is 0 m: it must lie in 1e-06 to 1000000 m");
  refuse(changed(
             [](CuboidList& list) { list.frame(0, 3) = std::numeric_limits<double>::quiet_NaN(); }),
         "the pose holds a number that is not finite");
  refuse(changed([](CuboidList& list) { list.cuboids[1].cells.max.y() = -1; }),
         "cuboid 1 from (7, -1, 0) to (8, -1, 1) is empty: max must be greater than min on each "
         "axis");
  refuse(changed([](CuboidList& list) { list.cuboids[0].cells.min.x() = kMinCellIndex - 1; }),
         "cuboid 0 from (-1073741825, 0, 3) to (20, 5, 4) is beyond the limits of cell indices");
  EXPECT_EQ(cases, 36);
}

// What scripts/check-cuboid-files has foreign readers load.
TEST(CuboidFiles, DISABLED_write_samples) {
  const char* folder = std::getenv("RMAP_CUBOID_SAMPLES");
  ASSERT_NE(folder, nullptr);
  test::Random random(23);
  const CuboidList tilted = test::near_cuboids(random, 200);
  for (const std::string ending : kEndings) {
    write_cuboids(std::filesystem::path(folder) / ("tilted" + ending), tilted);
    write_cuboids(std::filesystem::path(folder) / ("empty" + ending), {});
  }
}

}  // namespace
}  // namespace rmap
