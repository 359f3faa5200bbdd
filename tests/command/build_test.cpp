#include "command/command.hpp"

#include <numeric>

#include <gmock/gmock.h>

#include <rmap/map_file.hpp>
#include <rmap/scan_source.hpp>

namespace rmap::test {

namespace {

using testing::HasSubstr;

class Build : public CommandTest {
 protected:
  Build() { simulate_room("room"); }

  nlohmann::json build(const std::string& output, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments{"build", "room", "-o", output, "--resolution", "0.1"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return rmap_json(arguments);
  }
};

std::uint64_t sum_of(const nlohmann::json& counts) {
  std::uint64_t sum = 0;
  for (const auto& count : counts) sum += count.get<std::uint64_t>();
  return sum;
}

void expect_every_point_accounted_for(const nlohmann::json& report) {
  EXPECT_EQ(report["points"].get<std::uint64_t>(), report["inserted"].get<std::uint64_t>() +
                                                       report["cut"].get<std::uint64_t>() +
                                                       sum_of(report["skipped"]))
      << report;
}

TEST_F(Build, MakesTheMapThatTheLibraryMakes) {
  build("room.rmap");
  Grid grid({.resolution = 0.1});
  ScanRange scans = read_scans(folder() / "room");
  for (const Scan& scan : scans) grid.prepare(scan);
  scans.rewind();
  for (const Scan& scan : scans) grid.insert(scan);
  EXPECT_TRUE(same_map(grid, load(folder() / "room.rmap")));
}

TEST_F(Build, FirstHitHistoryIsThePlainPass) {
  const auto report = build("room.rmap", {"--history", "first-hit"});
  EXPECT_EQ(report["history"], "first_hit");
  Grid grid({.resolution = 0.1});
  for (const Scan& scan : read_scans(folder() / "room")) grid.insert(scan);
  EXPECT_TRUE(same_map(grid, load(folder() / "room.rmap")));
  EXPECT_GE(report["occupied"], build("complete.rmap")["occupied"]);
}

TEST_F(Build, ReportsEveryPointAndCell) {
  const auto report = build("room.rmap");
  expect_every_point_accounted_for(report);
  EXPECT_EQ(report["new_cells"], report["cells"]);
  EXPECT_GE(report["end_cells"], report["cells"]);
  EXPECT_GE(report["end_cells"], report["hits"]);
  EXPECT_GT(report["misses"], 0);
  EXPECT_EQ(report["output"], "room.rmap");
  EXPECT_GT(report["bytes_in_use"]["total"], 0);
  for (const char* phase : {"read", "prepare", "insert", "save"}) {
    EXPECT_GE(report["seconds"][phase], 0) << phase;
  }
}

TEST_F(Build, CountsWhatIsSkippedByReason) {
  const auto report =
      build("room.rmap", {"--max-range", "2.5", "--min-range", "2.1", "--ignore", "0,-1,-1,2,1,1",
                          "--ignore", "-2,-1,-1,0,0,1", "--crop", "-2,-2,0,2,2,2"});
  expect_every_point_accounted_for(report);
  EXPECT_GT(report["skipped"]["ignored"], 0);
  EXPECT_GT(report["skipped"]["cropped"], 0);
  EXPECT_GT(report["skipped"]["too_near"], 0);
  EXPECT_GT(report["cut"], 0);
  EXPECT_EQ(report["skipped"]["not_finite"], 0);
}

TEST_F(Build, CropKeepsTheMapWithinTheBox) {
  build("room.rmap", {"--crop", "-2,-2,0,2,2,2"});
  const auto info = rmap_json({"info", "room.rmap"});
  for (const double low : info["cell_bounds"]["min"]) EXPECT_GE(low, -20);
  for (const double high : info["cell_bounds"]["max"]) EXPECT_LE(high, 20);
  EXPECT_GE(info["cell_bounds"]["min"].back(), 0);
}

TEST_F(Build, IgnoreIsInTheSensorsFrame) {
  Grid grid({.resolution = 0.1});
  std::uint64_t ignored = 0;
  for (const Scan& scan : read_scans(folder() / "room")) {
    for (const Vector3f& point : scan.points) {
      ignored += Box{.min = {0, -1, -1}, .max = {2, 1, 1}}.contains(point.cast<double>());
    }
  }
  ASSERT_GT(ignored, 0u);
  EXPECT_EQ(build("room.rmap", {"--ignore", "0,-1,-1,2,1,1"})["skipped"]["ignored"], ignored);
}

TEST_F(Build, EveryTakesTheFirstOfSoMany) {
  EXPECT_EQ(build("a.rmap", {"--every", "2"})["scans"], 2);
  EXPECT_EQ(build("b.rmap", {"--every", "5"})["scans"], 1);
  const Grid grid = load(folder() / "a.rmap");
  const auto source = open_scans(folder() / "room");
  Scan scan;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(source->next(scan));
    if (i % 2 == 0) {
      EXPECT_TRUE(
          grid.scan_poses()[static_cast<std::size_t>(i) / 2].isApprox(scan.map_from_sensor));
    }
  }
}

TEST_F(Build, TakesSeveralSourcesAndSingleScans) {
  const auto report = rmap_json({"build", "room/000000.bin", "room/000001.bin", "room/000002.bin",
                                 "-o", "single.rmap", "--resolution", "0.1"});
  EXPECT_EQ(report["scans"], 3);
  build("room.rmap");
  EXPECT_EQ(bytes("single.rmap"), bytes("room.rmap"));
}

TEST_F(Build, SameBytesWhateverTheThreadsTheLayoutAndTheTree) {
  build("room.rmap");
  const std::vector<std::vector<std::string>> ways = {
      {},
      {"--threads", "2"},
      {"--threads", "3"},
      {"--layout", "cells"},
      {"--max-branches", "4", "--split", "linear"},
      {"--layout", "cells", "--threads", "2", "--max-branches", "64"},
  };
  for (const auto& way : ways) {
    SCOPED_TRACE(testing::PrintToString(way));
    build("other.rmap", way);
    EXPECT_EQ(bytes("other.rmap"), bytes("room.rmap"));
  }
}

TEST_F(Build, OntoGoesOnWithAMap) {
  rmap_done({"build", "room/000000.bin", "-o", "first.rmap", "--resolution", "0.1", "--prob-hit",
             "0.8", "--history", "first-hit"});
  const auto report =
      rmap_json({"build", "room/000001.bin", "room/000002.bin", "--onto", "first.rmap", "-o",
                 "all.rmap", "--history", "first-hit", "--layout", "cells", "--prob-hit", "0.80"});
  EXPECT_EQ(report["scans"], 2);
  EXPECT_EQ(report["history"], "first_hit");
  EXPECT_LT(report["new_cells"], report["cells"]);
  rmap_done({"build", "room", "-o", "whole.rmap", "--resolution", "0.1", "--prob-hit", "0.8",
             "--history", "first-hit"});
  EXPECT_EQ(bytes("all.rmap"), bytes("whole.rmap"));

  // Preparing later scans cannot give the earlier ones back their misses.
  EXPECT_EQ(
      rmap_json({"build", "room/000001.bin", "--onto", "first.rmap", "-o", "more.rmap"})["history"],
      "first_hit");
  EXPECT_THAT(rmap_refused(1, {"build", "room", "--onto", "first.rmap", "-o", "b.rmap",
                               "--prob-hit", "0.7"}),
              testing::AllOf(HasSubstr("--prob-hit is 0.7"), HasSubstr("first.rmap"),
                             HasSubstr("made with 0.8")));
  EXPECT_THAT(rmap_refused(1, {"build", "room", "--onto", "first.rmap", "-o", "b.rmap", "--beams",
                               "per_end_cell"}),
              HasSubstr("--beams is per_end_cell"));
}

TEST_F(Build, OptionsReachTheMap) {
  build("room.rmap", {"--prob-hit",
                      "0.75",
                      "--prob-miss",
                      "0.35",
                      "--clamp-min",
                      "0.05",
                      "--clamp-max",
                      "0.99",
                      "--prior",
                      "0.45",
                      "--occupied-threshold",
                      "0.6",
                      "--saturation",
                      "freeze",
                      "--free-probability",
                      "0.1",
                      "--beams",
                      "per-end-cell",
                      "--min-range",
                      "0.5",
                      "--max-range",
                      "30"});
  const nlohmann::json expected = {
      {"resolution", 0.1},         {"prob_hit", 0.75},        {"prob_miss", 0.35},
      {"clamp_min", 0.05},         {"clamp_max", 0.99},       {"prior", 0.45},
      {"occupied_threshold", 0.6}, {"free_probability", 0.1}, {"saturation", "freeze"},
      {"min_range", 0.5},          {"max_range", 30.0},       {"beams", "per_end_cell"}};
  EXPECT_EQ(rmap_json({"info", "room.rmap"})["options"], expected);
}

TEST_F(Build, DryRunChecksAndWritesNothing) {
  const auto before = listing();
  const auto report = rmap_json({"build", "room", "--dry-run", "--resolution", "0.1"});
  EXPECT_EQ(report["scans"], 3);
  EXPECT_EQ(report["points"], rmap_json({"info", "room"})["points"]["total"]);
  EXPECT_EQ(report["problems"], nlohmann::json::array());
  EXPECT_EQ(listing(), before);
}

TEST_F(Build, DryRunFindsAllProblems) {
  write("room/000000.bin", "seven77");
  write("room/000002.bin", "");
  const Outcome outcome = rmap({"build", "room", "--dry-run", "--resolution", "0.1", "--json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.json()["scans"], 1);
  ASSERT_EQ(outcome.json()["problems"].size(), 2u);
  EXPECT_THAT(outcome.json()["problems"][0].get<std::string>(), HasSubstr("000000.bin"));
  EXPECT_THAT(outcome.json()["problems"][1].get<std::string>(), HasSubstr("000002.bin"));
  EXPECT_THAT(outcome.err, HasSubstr("2 problems"));
}

TEST_F(Build, BadPointsAreCountedOrRefused) {
  std::string scan = bytes("room/000001.bin");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scan.replace(0, sizeof nan, reinterpret_cast<const char*>(&nan), sizeof nan);
  write("room/000001.bin", scan);
  const auto report = build("room.rmap", {"--crop", "-100,-100,-100,100,100,100"});
  EXPECT_EQ(report["skipped"]["not_finite"], 1);
  EXPECT_EQ(report["skipped"]["cropped"], 0);
  expect_every_point_accounted_for(report);
  EXPECT_EQ(rmap_json({"info", "room"})["not_finite"], 1);
  rmap_refused(1,
               {"build", "room", "-o", "bad.rmap", "--resolution", "0.1", "--bad-points", "error"});
  EXPECT_FALSE(std::filesystem::exists(folder() / "bad.rmap"));
}

}  // namespace

}  // namespace rmap::test
