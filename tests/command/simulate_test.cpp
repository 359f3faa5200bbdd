#include "command/command.hpp"

#include <gmock/gmock.h>

#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>
#include <rmap/simulation.hpp>

namespace rmap::test {

namespace {

using testing::HasSubstr;
using Simulate = CommandTest;

TEST_F(Simulate, WritesTheScansOfTheLibrary) {
  rmap_done({"simulate", "moving", "--scans", "3", "--sensor", "lidar16", "--noise", "0.02",
             "--dropped", "0.1", "--seed", "18446744073709551615", "-o", "yard"});
  const Simulation simulation = make_simulation("moving", {.scans = 3,
                                                           .sensor = make_sensor("lidar16"),
                                                           .noise = 0.02,
                                                           .dropped = 0.1,
                                                           .seed = 18446744073709551615U});
  std::size_t index = 0;
  for (const Scan& scan : read_scans(folder() / "yard")) {
    const Scan expected = simulation.scan(index++);
    EXPECT_EQ(scan.points, expected.points);
    EXPECT_EQ(scan.map_from_sensor.matrix(), expected.map_from_sensor.matrix());
  }
  EXPECT_EQ(index, 3u);
}

TEST_F(Simulate, SameSeedSameBytes) {
  for (const char* name : {"a", "b"}) {
    rmap_done({"simulate", "noisy_room", "--scans", "2", "--sensor", "lidar16", "--seed", "5", "-o",
               name});
  }
  rmap_done(
      {"simulate", "noisy_room", "--scans", "2", "--sensor", "lidar16", "--seed", "6", "-o", "c"});
  const auto files = listing("a");
  EXPECT_THAT(files,
              testing::ElementsAre("000000.bin", "000001.bin", "poses.txt", "truth", "truth.json"));
  for (const std::string file :
       {"000000.bin", "000001.bin", "poses.txt", "truth.json", "truth/surface.pcd"}) {
    EXPECT_EQ(bytes("a/" + file), bytes("b/" + file)) << file;
  }
  EXPECT_NE(bytes("a/000000.bin"), bytes("c/000000.bin"));
}

TEST_F(Simulate, WritesTheTruthExactly) {
  rmap_done(
      {"simulate", "moving", "--scans", "2", "--format", "pcd", "--spacing", "0.3", "-o", "yard"});
  EXPECT_THAT(listing("yard"), testing::Contains("000001.pcd"));
  const auto truth = nlohmann::json::parse(bytes("yard/truth.json"));
  const Simulation simulation = make_simulation("moving", {.scans = 2});
  EXPECT_EQ(truth["scene"], "moving");
  EXPECT_EQ(truth["times"], nlohmann::json({simulation.time(0), simulation.time(1)}));
  const auto& objects = simulation.scene().objects();
  ASSERT_EQ(truth["objects"].size(), objects.size());
  int moving = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const auto& object = truth["objects"][i];
    EXPECT_EQ(object["name"], objects[i].name);
    EXPECT_EQ(object["static"], is_static(objects[i]));
    EXPECT_EQ(object["map_from_object"][3], objects[i].map_from_object(0, 3));
    EXPECT_EQ(object["motion"].size(), objects[i].motion.size());
    if (const auto* cuboid = std::get_if<CuboidShape>(&objects[i].shape)) {
      EXPECT_EQ(object["shape"]["type"], "cuboid");
      EXPECT_EQ(object["shape"]["size"][2], cuboid->size.z());
    }
    moving += is_static(objects[i]) ? 0 : 1;
  }
  EXPECT_GT(moving, 0);

  const auto surface = read_points(folder() / "yard/truth/surface.pcd");
  EXPECT_EQ(truth["surface"]["points"], surface.size());
  EXPECT_EQ(truth["surface"]["spacing"], 0.3);
  for (const Vector3f& point : surface) {
    ASSERT_LT(simulation.scene().distance_to_surface(point.cast<double>()), 1e-5);
  }
}

TEST_F(Simulate, ListsItsScenes) {
  const auto scenes = rmap_json({"simulate", "--list"});
  ASSERT_EQ(scenes.size(), scene_names().size());
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    EXPECT_EQ(scenes[i]["scene"], scene_names()[i]);
    EXPECT_FALSE(scenes[i]["description"].get<std::string>().empty());
    EXPECT_GT(scenes[i]["scans"], 0);
  }
}

TEST_F(Simulate, LeavesNothingOfWhatFails) {
  EXPECT_THAT(rmap_refused(1, {"simulate", "beach", "-o", "x"}),
              testing::AllOf(HasSubstr("beach"), HasSubstr("street")));
  EXPECT_THAT(rmap_refused(1, {"simulate", "room", "--sensor", "sonar", "-o", "x"}),
              testing::AllOf(HasSubstr("sonar"), HasSubstr("lidar16")));
  EXPECT_THAT(rmap_refused(1, {"simulate", "room", "--dropped", "2", "-o", "x"}),
              HasSubstr("dropped"));
  EXPECT_THAT(rmap_refused(1, {"simulate", "room", "--spacing", "0", "--scans", "1", "-o", "x"}),
              HasSubstr("spacing"));
  EXPECT_THAT(listing(), testing::IsEmpty());

  simulate_room("room", 1);
  EXPECT_THAT(rmap_refused(1, {"simulate", "room", "-o", "room"}), HasSubstr("already"));
  // A folder with other things in it is fine, and they stay.
  std::filesystem::create_directory(folder() / "mine");
  write("mine/notes.txt", "mine");
  simulate_room("mine", 1);
  EXPECT_EQ(bytes("mine/notes.txt"), "mine");
  write("mine/truth.json", "mine");
  for (const char* file : {"mine/000000.bin", "mine/poses.txt"}) {
    std::filesystem::remove(folder() / file);
  }
  EXPECT_THAT(rmap_refused(1, {"simulate", "room", "--scans", "1", "-o", "mine"}),
              HasSubstr("already"));
  EXPECT_EQ(bytes("mine/truth.json"), "mine");
  EXPECT_THAT(listing("mine"), testing::ElementsAre("notes.txt", "truth", "truth.json"));
}

}  // namespace

}  // namespace rmap::test
