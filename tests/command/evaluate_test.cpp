#include "command/command.hpp"

#include <gmock/gmock.h>

namespace rmap::test {

namespace {

using testing::HasSubstr;
using Evaluate = CommandTest;

TEST_F(Evaluate, WritesResultsAndTables) {
  simulate_room("room");
  const auto answer = rmap_json({"evaluate", "room", "-o", "out", "--resolution", "0.2",
                                 "--experiments", "rtree,multiresolution", "--repetitions", "1"});
  EXPECT_THAT(listing("out"), testing::ElementsAre("checks.csv", "query_cuboids.csv",
                                                   "results.json", "rtree.csv", "sequences.csv"));
  EXPECT_EQ(nlohmann::json::parse(bytes("out/results.json")), answer);
  EXPECT_EQ(answer["sequences"][0]["sequence"], "room");
  EXPECT_EQ(answer["sequences"][0]["scans"], 3);
  EXPECT_EQ(answer["rtree"].size(), 30u);
  EXPECT_TRUE(answer["accuracy"].empty());
  EXPECT_THAT(answer["command"].get<std::string>(), HasSubstr("rmap evaluate room"));
  EXPECT_TRUE(answer["machine"].contains("octomap"));
}

TEST_F(Evaluate, TheSameFiguresEachTime) {
  const auto accuracy = [&](const char* out) {
    return rmap_json({"evaluate", "--scans", "2", "--resolution", "0.4", "--experiments",
                      "accuracy", "-o", out})["accuracy"];
  };
  const auto rows = accuracy("a");
  EXPECT_FALSE(rows.empty());
  EXPECT_EQ(rows, accuracy("b"));
}

TEST_F(Evaluate, RefusesWhatMakesNoSense) {
  simulate_room("room");
  EXPECT_THAT(rmap_refused(2, {"evaluate", "room"}), HasSubstr("-o"));
  EXPECT_THAT(rmap_refused(2, {"evaluate", "room", "-o", "out", "--experiments", "speed"}),
              HasSubstr("\"speed\""));
  EXPECT_THAT(rmap_refused(2, {"evaluate", "room", "-o", "out", "--resolution", "fine"}),
              HasSubstr("\"fine\""));
  EXPECT_THAT(rmap_refused(2, {"evaluate", "room", "-o", "out", "--experiments", ""}),
              HasSubstr("--experiments"));
  EXPECT_THAT(rmap_refused(2, {"evaluate", "room", "-o", "out", "--resolution", ""}),
              HasSubstr("--resolution"));
  EXPECT_THAT(rmap_refused(1, {"evaluate", "nowhere", "-o", "out"}), HasSubstr("nowhere"));
  EXPECT_THAT(rmap_refused(1, {"evaluate", "room", "-o", "out", "--resolution", "0"}),
              HasSubstr("resolution"));
  rmap_done({"evaluate", "room", "-o", "out", "--experiments", "multiresolution"});
  EXPECT_THAT(rmap_refused(1, {"evaluate", "room", "-o", "out"}), HasSubstr("results.json"));
}

}  // namespace

}  // namespace rmap::test
