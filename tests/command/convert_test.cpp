#include "command/command.hpp"
#include "support/random.hpp"

#include <algorithm>

#include <gmock/gmock.h>

#include <rmap/cells.hpp>
#include <rmap/map_file.hpp>
#include <rmap/multiresolution.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::test {

namespace {

using testing::HasSubstr;

class Convert : public CommandTest {
 protected:
  Convert() : grid_({.resolution = 0.5}) {
    Random random(72);
    for (int i = 0; i < 300; ++i) grid_.set(random.cell(-10, 10), random.real(0.1, 0.97));
    save(grid_, folder() / "map.rmap");
  }

  Grid grid_;
};

TEST_F(Convert, MapsToCells) {
  const std::size_t occupied = count_cells(grid_, {.occupied_only = true});
  ASSERT_LT(occupied, grid_.cell_count());
  EXPECT_EQ(rmap_json({"convert", "map.rmap", "occupied.csv"})["cells"], occupied);
  EXPECT_EQ(rmap_json({"convert", "map.rmap", "all.csv", "--cells", "all"})["cells"],
            grid_.cell_count());
  const std::string rows = bytes("all.csv");
  EXPECT_TRUE(rows.starts_with("x,y,z,size,probability,state\n"));
  EXPECT_EQ(static_cast<std::size_t>(std::count(rows.begin(), rows.end(), '\n')),
            grid_.cell_count() + 1);

  rmap_done({"convert", "map.rmap", "map.PCD"});
  const auto points = read_points(folder() / "map.PCD");
  ASSERT_EQ(points.size(), occupied);
  for (const Vector3f& point : points) {
    EXPECT_EQ(grid_.state(point.cast<double>()), State::occupied);
  }
  rmap_done({"convert", "map.rmap", "map.ply"});
  EXPECT_TRUE(bytes("map.ply").starts_with("ply\nformat binary_little_endian 1.0\n"));
}

TEST_F(Convert, MapsToMaps) {
  rmap_done({"convert", "map.rmap", "copy.rmap"});
  EXPECT_EQ(bytes("copy.rmap"), bytes("map.rmap"));

  rmap_done({"convert", "map.rmap", "coarse.rmap", "--coarsen", "3", "--criterion", "max"});
  EXPECT_TRUE(same_map(load(folder() / "coarse.rmap"), coarsen(grid_, 3, Criterion::max)));

  rmap_done({"convert", "map.rmap", "pruned.rmap", "--prune", "0.5"});
  Grid pruned = grid_;
  ASSERT_GT(pruned.prune(0.5), 0u);
  EXPECT_TRUE(same_map(load(folder() / "pruned.rmap"), pruned));
}

TEST_F(Convert, CropKeepsTheCellsOfTheBox) {
  // From within a cell to a border of one; then all of space but a half.
  const std::vector<std::pair<std::string, Box>> crops = {
      {"-1.2,-2,0,3,2.5,4.9", {.min = {-1.2, -2, 0}, .max = {3, 2.5, 4.9}}},
      {"0,-1e6,-1e6,1e6,1e6,1e6", {.min = {0, -1e6, -1e6}, .max = {1e6, 1e6, 1e6}}},
  };
  for (const auto& [text, box] : crops) {
    SCOPED_TRACE(text);
    rmap_done({"convert", "map.rmap", "crop.rmap", "--crop", text});
    const Grid cropped = load(folder() / "crop.rmap");
    std::vector<CellValue> expected;
    for (const CellValue& entry : cells(grid_, {.box = box})) expected.push_back(entry);
    std::vector<CellValue> found;
    for (const CellValue& entry : cells(cropped)) found.push_back(entry);
    EXPECT_GT(found.size(), 10u);
    EXPECT_LT(found.size(), grid_.cell_count());
    EXPECT_EQ(found, expected);
  }
}

TEST_F(Convert, ScanFoldersThereAndBack) {
  simulate_room("room");
  EXPECT_EQ(rmap_json({"convert", "room", "room_pcd", "--format", "pcd"})["scans"], 3);
  EXPECT_THAT(listing("room_pcd"),
              testing::ElementsAre("000000.pcd", "000001.pcd", "000002.pcd", "poses.txt"));
  rmap_done({"convert", "room_pcd", "room_bin", "--format", "bin"});
  for (const char* file : {"000000.bin", "000001.bin", "000002.bin", "poses.txt"}) {
    EXPECT_EQ(bytes(std::filesystem::path("room_bin") / file),
              bytes(std::filesystem::path("room") / file))
        << file;
  }
  EXPECT_THAT(rmap_refused(1, {"convert", "room", "room_bin"}), HasSubstr("already"));
}

TEST_F(Convert, ABrokenScanLeavesNoFolder) {
  simulate_room("room");
  write("room/000002.bin", "seven77");
  EXPECT_THAT(rmap_refused(1, {"convert", "room", "new/room_pcd", "--format", "pcd"}),
              HasSubstr("000002.bin"));
  EXPECT_FALSE(std::filesystem::exists(folder() / "new/room_pcd"));
}

TEST_F(Convert, Clouds) {
  simulate_room("room");
  EXPECT_EQ(rmap_json({"convert", "room/000000.bin", "cloud.pcd"})["points"],
            read_points(folder() / "room/000000.bin").size());
  rmap_done({"convert", "cloud.pcd", "cloud.bin"});
  EXPECT_EQ(bytes("cloud.bin"), bytes("room/000000.bin"));
}

TEST_F(Convert, OptionsWithoutEffectAreRefused) {
  simulate_room("room");
  EXPECT_THAT(rmap_refused(2, {"convert", "map.rmap", "a.rmap", "--cells", "all"}),
              HasSubstr("--cells has no effect"));
  EXPECT_THAT(rmap_refused(2, {"convert", "map.rmap", "a.csv", "--format", "bin"}),
              HasSubstr("--format has no effect"));
  EXPECT_THAT(rmap_refused(2, {"convert", "room", "other", "--prune", "0.5"}),
              HasSubstr("--prune has no effect"));
  EXPECT_THAT(rmap_refused(2, {"convert", "room/000000.bin", "a.pcd", "--coarsen", "2"}),
              HasSubstr("--coarsen has no effect"));
}

}  // namespace

}  // namespace rmap::test
