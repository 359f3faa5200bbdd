#include "command/command.hpp"

#include <gmock/gmock.h>

#include <rmap/map_file.hpp>

namespace rmap::test {

namespace {

using MainJob = CommandTest;

// The whole way of a user, each step with what the one before has left.
TEST_F(MainJob, FromASceneToAMapAndItsAnswers) {
  const auto simulated =
      rmap_json({"simulate", "room", "--scans", "4", "--spacing", "0.05", "-o", "room"});
  EXPECT_EQ(simulated["scans"], 4);
  const auto folder_info = rmap_json({"info", "room"});
  EXPECT_EQ(folder_info["points"]["total"], simulated["points"]);

  const auto built = rmap_json({"build", "room", "-o", "room.rmap", "--resolution", "0.1"});
  EXPECT_EQ(built["scans"], 4);
  EXPECT_EQ(built["points"], simulated["points"]);
  EXPECT_GT(built["occupied"], 1000);

  const auto info = rmap_json({"info", "room.rmap"});
  EXPECT_EQ(info["cells"], built["cells"]);
  EXPECT_EQ(info["occupied"], built["occupied"]);
  EXPECT_EQ(info["scans"], 4);
  EXPECT_EQ(info["history"], "complete");

  // A ray from the middle of the room meets the wall, the wall is occupied, the middle free.
  const auto ray = rmap_json({"query", "room.rmap", "cast", "0,0,2", "1,0,0"});
  ASSERT_EQ(ray["hit"], true);
  EXPECT_NEAR(ray["distance"].get<double>(), 3, 0.2);
  const double wall = ray["distance"].get<double>() + 0.01;
  EXPECT_EQ(rmap_json({"query", "room.rmap", "point", std::to_string(wall) + ",0,2"})["state"],
            "occupied");
  EXPECT_EQ(rmap_json({"query", "room.rmap", "point", "0,0,2"})["state"], "assumed_free");
  const auto box = rmap_json({"query", "room.rmap", "box", "-4,-4,-1,4,4,4"});
  EXPECT_EQ(box["existing_cells"], info["cells"]);
  EXPECT_EQ(box["occupied_cells"], info["occupied"]);

  const auto rows = rmap_json({"convert", "room.rmap", "room.csv"});
  EXPECT_EQ(rows["cells"], info["occupied"]);
  rmap_done({"convert", "room.rmap", "copy.rmap"});
  EXPECT_EQ(rmap_json({"compare", "room.rmap", "copy.rmap"})["same_map"], true);

  // The true surface: nearly all of it was seen, and next to nothing is where it is not.
  const auto truth = rmap_json({"compare", "room.rmap", "room/truth/surface.pcd"});
  EXPECT_EQ(truth["points"], simulated["surface_points"]);
  EXPECT_GT(truth["in_occupied"].get<double>(), 0.5 * truth["points"].get<double>());
  EXPECT_LT(truth["occupied_without_point"].get<double>(), 0.1 * truth["occupied"].get<double>());

  const auto sum = rmap_json({"merge", "room.rmap", "copy.rmap", "-o", "sum.rmap"});
  EXPECT_EQ(sum["cells"], info["cells"]);
  EXPECT_EQ(sum["scans"], 8);
  EXPECT_EQ(load(folder() / "sum.rmap").check(), std::nullopt);
}

TEST_F(MainJob, WordsForPeople) {
  simulate_room("room");
  EXPECT_THAT(rmap_done({"build", "room", "-o", "room.rmap", "--resolution", "0.1"}).out,
              testing::HasSubstr("3 scans"));
  EXPECT_THAT(rmap_done({"info", "room.rmap", "room", "room/truth/surface.pcd"}).out,
              testing::AllOf(testing::HasSubstr("room.rmap: map of 0.1 m cells"),
                             testing::HasSubstr("room: 3 scans"),
                             testing::HasSubstr("surface.pcd: cloud of")));
  EXPECT_THAT(rmap_done({"query", "room.rmap", "point", "0,0,2"}).out,
              testing::HasSubstr("assumed_free"));
  EXPECT_THAT(rmap_done({"query", "room.rmap", "box", "-4,-4,-1,4,4,4"}).out,
              testing::HasSubstr("(-4, -4, -1) to (4, 4, 4)"));
  EXPECT_THAT(rmap_done({"query", "room.rmap", "cast", "0,0,2", "1,0,0"}).out,
              testing::HasSubstr("min_x"));
  EXPECT_THAT(rmap_done({"query", "room.rmap", "cells", "--occupied"}).out,
              testing::HasSubstr("occupied\n"));
  EXPECT_THAT(rmap_done({"compare", "room.rmap", "room.rmap"}).out,
              testing::HasSubstr("the same map"));
  EXPECT_THAT(rmap_done({"compare", "room.rmap", "room/truth/surface.pcd"}).out,
              testing::HasSubstr("assumed_free cells"));
  EXPECT_THAT(rmap_done({"merge", "room.rmap", "room.rmap", "-o", "sum.rmap"}).out,
              testing::HasSubstr("sum.rmap: 2 maps with"));
  EXPECT_THAT(rmap_done({"convert", "room.rmap", "room.ply"}).out,
              testing::HasSubstr("room.ply: "));
  EXPECT_THAT(rmap_done({"simulate", "--list"}).out, testing::HasSubstr("street"));
  EXPECT_THAT(rmap_done({"--version"}).out,
              testing::MatchesRegex("rmap [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

}  // namespace

}  // namespace rmap::test
