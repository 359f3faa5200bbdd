#include "command/command.hpp"
#include "support/random.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include <rmap/map_file.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::test {

namespace {

using testing::HasSubstr;
using Info = CommandTest;

TEST_F(Info, MapsInEitherLayout) {
  Grid grid({.resolution = 0.25});
  Random random(75);
  for (int i = 0; i < 3000; ++i) grid.set(random.cell(-40, 40), 0.9);
  save(grid, folder() / "map.rmap");

  const auto blocks = rmap_json({"info", "map.rmap"});
  EXPECT_EQ(blocks["kind"], "map");
  EXPECT_EQ(blocks["resolution"], 0.25);
  EXPECT_EQ(blocks["cells"], grid.cell_count());
  EXPECT_EQ(blocks["occupied"], grid.cell_count());
  EXPECT_EQ(blocks["blocks"], grid.leaf_count());
  EXPECT_EQ(blocks["file_bytes"], std::filesystem::file_size(folder() / "map.rmap"));
  EXPECT_EQ(blocks["layout"], "blocks");
  EXPECT_EQ(blocks["rtree"]["items"], grid.leaf_count());
  EXPECT_EQ(blocks["rtree"]["height"], blocks["rtree"]["levels"].size());
  const Box bounds = grid.lattice().metric(grid.bounds());
  EXPECT_EQ(blocks["bounds"]["min"], numbers(bounds.min));
  EXPECT_EQ(blocks["bounds"]["max"], numbers(bounds.max));
  const auto& bytes = blocks["bytes_in_use"];
  EXPECT_EQ(bytes["total"].get<std::size_t>(),
            bytes["nodes"].get<std::size_t>() + bytes["blocks"].get<std::size_t>() +
                bytes["values"].get<std::size_t>() + bytes["records"].get<std::size_t>());
  EXPECT_EQ(blocks["options"]["max_range"], nullptr) << "infinite";
  EXPECT_EQ(blocks["chunks"].back()["type"].get<std::string>().substr(0, 3), "END");

  const auto cells = rmap_json(
      {"info", "map.rmap", "--layout", "cells", "--max-branches", "5", "--split", "linear"});
  EXPECT_EQ(cells["layout"], "cells");
  EXPECT_EQ(cells["max_branches"], 5);
  EXPECT_EQ(cells["split"], "linear");
  EXPECT_EQ(cells["rtree"]["items"], grid.cell_count());
  EXPECT_GT(cells["rtree"]["height"], blocks["rtree"]["height"]);
}

TEST_F(Info, AnEmptyMap) {
  save(Grid({.resolution = 0.25}), folder() / "map.rmap");
  const auto info = rmap_json({"info", "map.rmap"});
  EXPECT_EQ(info["cells"], 0);
  EXPECT_EQ(info["bounds"], nullptr);
  EXPECT_THAT(rmap_done({"info", "map.rmap"}).out, HasSubstr("bounds      none"));
}

TEST_F(Info, FoldersOfScans) {
  simulate_room("room", 4);
  std::uint64_t total = 0;
  std::size_t largest = 0;
  std::size_t smallest = SIZE_MAX;
  double range_max = 0;
  double path = 0;
  std::optional<Vector3d> last;
  Box bounds{.min = Vector3d::Constant(1e9), .max = Vector3d::Constant(-1e9)};
  for (const Scan& scan : read_scans(folder() / "room")) {
    total += scan.points.size();
    largest = std::max(largest, scan.points.size());
    smallest = std::min(smallest, scan.points.size());
    for (const Vector3f& point : scan.points) {
      range_max = std::max(range_max, point.cast<double>().norm());
      const Vector3d in_map = transformed(scan.map_from_sensor, point);
      bounds.min = bounds.min.cwiseMin(in_map);
      bounds.max = bounds.max.cwiseMax(in_map);
    }
    const Vector3d position = scan.map_from_sensor.translation();
    if (last) path += (position - *last).norm();
    last = position;
  }
  const auto info = rmap_json({"info", "room"});
  EXPECT_EQ(info["kind"], "scans");
  EXPECT_EQ(info["scans"], 4);
  EXPECT_EQ(info["points"]["total"], total);
  EXPECT_EQ(info["points"]["min"], smallest);
  EXPECT_EQ(info["points"]["max"], largest);
  EXPECT_EQ(info["ranges"]["max"], range_max);
  EXPECT_DOUBLE_EQ(info["path_length"], path);
  EXPECT_EQ(info["not_finite"], 0);
  EXPECT_EQ(info["bounds"]["min"], numbers(bounds.min));
  EXPECT_EQ(info["bounds"]["max"], numbers(bounds.max));
}

TEST_F(Info, CloudsAndSeveralFiles) {
  const std::vector<Vector3f> points = {{1, 2, 3}, {-1, 5, 0}, {NAN, 0, 0}, {0, INFINITY, 0}};
  write_points(folder() / "cloud.pcd", points);
  write_points(folder() / "empty.pcd", {});
  const auto both = rmap_json({"info", "cloud.pcd", "empty.pcd"});
  ASSERT_EQ(both.size(), 2u);
  EXPECT_EQ(both[0]["kind"], "cloud");
  EXPECT_EQ(both[0]["points"], 4);
  EXPECT_EQ(both[0]["finite"], 2);
  EXPECT_EQ(both[0]["bounds"]["min"], nlohmann::json({-1.0, 2.0, 0.0}));
  EXPECT_EQ(both[1]["points"], 0);
  EXPECT_EQ(both[1]["bounds"], nullptr);
}

}  // namespace

}  // namespace rmap::test
