// Maps that earlier releases wrote must load for ever. A golden file is written once,
// with the release that brings its format version, and is never written again:
//
//     io_tests --gtest_also_run_disabled_tests --gtest_filter='GoldenMap.DISABLED_write_*'
//
// writes that of the present version into tests/golden, next to those of the versions
// before it. Contents are compared and not bytes, which differ between releases of zstd.

#include "io/files.hpp"
#include "io/map_samples.hpp"
#include "io/raw_map.hpp"

#include <gtest/gtest.h>

#include <rmap/map_file.hpp>

namespace rmap {
namespace {

const std::filesystem::path kGoldenV1 = std::filesystem::path(RMAP_GOLDEN_DIR) / "v1_map.rmap";

// Cells of every kind of place and value, and enough of them for compression to pay.
std::vector<CellValue> golden_cells() {
  std::vector<CellValue> cells = {{{0, 0, 0}, 100},
                                  {{7, 7, 7}, -200},
                                  {{8, 0, 0}, 32767},
                                  {{-1, -1, -1}, -32768},
                                  {{kMinCellIndex, kMinCellIndex, kMinCellIndex}, 1},
                                  {{kMaxCellIndex, kMaxCellIndex, kMaxCellIndex}, -1},
                                  {{kMinCellIndex, 12, kMaxCellIndex}, 0}};
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 10; ++k) {
      cells.push_back({{100 + i, -50, k}, static_cast<Value>(847 - 405 * ((i + k) % 3))});
    }
  }
  for (BlockPosition position = 0; position < kBlockCells; ++position) {
    cells.push_back({Cell(-800, 80, 8) + block_offset(position), static_cast<Value>(position)});
  }
  return cells;
}

std::vector<Pose> golden_poses() {
  Pose turned = Pose::Identity();
  turned.linear() << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  turned.translation() << 1.5, -2.25, 0.1;
  Pose tilted = Pose::Identity();
  tilted.linear() << 1, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8;
  tilted.translation() << -1e6, 0, 1e-6;
  return {turned, tilted};
}

Grid golden_map() {
  Grid grid(test::all_options_changed());
  for (const auto& [cell, value] : golden_cells()) grid.set_value(cell, value);
  grid.restore(History::complete, golden_poses());
  return grid;
}

TEST(GoldenMap, DISABLED_write_v1) { save(golden_map(), kGoldenV1); }

TEST(GoldenMap, of_version_1_is_read) {
  const Grid grid = load(kGoldenV1);
  EXPECT_EQ(grid.check(), std::nullopt);
  EXPECT_EQ(grid.options(), test::all_options_changed());
  EXPECT_EQ(grid.history(), History::complete);

  const std::vector<CellValue> cells = golden_cells();
  EXPECT_EQ(cells.size(), 719U);
  EXPECT_EQ(grid.cell_count(), cells.size());
  for (const auto& [cell, value] : cells) {
    EXPECT_EQ(grid.cell_value(cell), value) << cell.transpose();
  }
  const std::vector<Pose> poses = golden_poses();
  ASSERT_EQ(grid.scan_poses().size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(grid.scan_poses()[i].matrix(), poses[i].matrix()) << i;
  }
}

TEST(GoldenMap, of_version_1_describes_itself) {
  const MapFileInfo info = read_map_info(kGoldenV1);
  EXPECT_EQ(info.format_version, 1U);
  EXPECT_EQ(info.scans, 2U);
  EXPECT_EQ(info.blocks, 13U);
  EXPECT_EQ(info.cells, 719U);
  ASSERT_EQ(info.chunks.size(), 5U);
  EXPECT_EQ(info.chunks[3].type, "CELL");
  EXPECT_TRUE(info.chunks[3].compressed);
  EXPECT_FALSE(info.chunks[1].compressed);
}

TEST(GoldenMap, of_version_1_is_what_this_release_writes) {
  const test::RawMap golden = test::parsed(test::read_text(kGoldenV1));
  EXPECT_EQ(test::decompressed(golden), test::raw_map(golden_map()));
  EXPECT_EQ(test::bytes_of(golden), test::read_text(kGoldenV1));
}

}  // namespace
}  // namespace rmap
