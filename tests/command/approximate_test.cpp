#include "command/command.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <rmap/approximate.hpp>
#include <rmap/cuboid_error.hpp>
#include <rmap/cuboid_files.hpp>
#include <rmap/map_file.hpp>
#include <rmap/scan_files.hpp>
#include <rmap/simulation.hpp>

namespace rmap::test {

namespace {

using testing::AllOf;
using testing::HasSubstr;

class Approximate : public CommandTest {
 protected:
  /// A map of the room, and its occupied cells.
  std::vector<CountedCell> build_room() const {
    simulate_room("room");
    rmap_done({"build", "room", "-o", "room.rmap", "--resolution", "0.1"});
    return occupied_cells(load(folder() / "room.rmap"));
  }
};

TEST_F(Approximate, makes_what_the_library_makes) {
  const auto cells = build_room();
  for (const char* preset : {"exact", "default", "compact", "sketch"}) {
    SCOPED_TRACE(preset);
    const auto answer =
        rmap_json({"approximate", "room.rmap", "-o", "room.rcs", "--preset", preset});
    const auto expected = approximate(cells, approximation_preset(preset)).cuboids;
    const CuboidList list = read_cuboids(folder() / "room.rcs");
    EXPECT_EQ(list.cuboids, expected);
    EXPECT_EQ(list.resolution, 0.1);
    const CuboidError error = cuboid_error(cells, expected);
    EXPECT_EQ(answer["preset"], preset);
    EXPECT_EQ(answer["method"], "cover");
    EXPECT_EQ(answer["cells"], cells.size());
    EXPECT_EQ(answer["cuboids"], expected.size());
    EXPECT_EQ(answer["lost_cells"], error.lost_cells);
    EXPECT_EQ(answer["false_cells"], error.false_cells);
    EXPECT_EQ(answer["false_share"], error.false_share());
    EXPECT_EQ(answer["farthest_false"], error.farthest_false);
    EXPECT_EQ(answer["farthest_lost"], error.farthest_lost);
    EXPECT_EQ(answer["covered_points"], error.points - error.lost_points);
    EXPECT_EQ(answer["bytes"]["plain"], 24 * expected.size());
    for (const char* part : {"read", "quantise", "frame", "approximate"}) {
      EXPECT_GE(answer["seconds"][part], 0.0);
    }

    const auto evaluation = rmap_json({"evaluate-cuboids", "room.rmap", "room.rcs"});
    EXPECT_EQ(evaluation["lost_cells"], error.lost_cells);
    EXPECT_EQ(evaluation["false_cells"], error.false_cells);
    EXPECT_GT(evaluation["rtree_bytes"]["16"], 0);
    EXPECT_TRUE(evaluation["lower_bound"].is_null());
  }
  const auto info = rmap_json({"info", "room.rcs"});
  EXPECT_EQ(info["kind"], "cuboids");
  EXPECT_THAT(rmap_done({"info", "room.rcs"}).out, HasSubstr("cuboids"));
}

TEST_F(Approximate, options_mean_what_the_library_means) {
  const auto cells = build_room();
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"approximate", "room.rmap", "-o", "out.rcs"});
    rmap_json(arguments);
    return read_cuboids(folder() / "out.rcs").cuboids;
  };
  const auto expected = [&](const ApproximationOptions& options) {
    return approximate(cells, options).cuboids;
  };
  EXPECT_EQ(run({}), expected({}));
  EXPECT_EQ(run({"--outer", "2", "--inner", "1"}),
            expected({.outer = 2, .inner = 1, .max_false = std::nullopt}));
  EXPECT_EQ(run({"--max-false", "0.4"}), expected({.outer = std::nullopt, .max_false = 0.4}));
  EXPECT_EQ(run({"--max-false", "0.1", "--outer", "1"}), expected({.outer = 1, .max_false = 0.1}));
  EXPECT_EQ(run({"--method", "runs"}), expected({.method = CuboidMethod::runs}));
  EXPECT_EQ(run({"--method", "midpoint", "--fill", "0.5", "--sigma", "0.9"}),
            expected({.method = CuboidMethod::midpoint, .sigma = 0.9, .fill = 0.5}));
  EXPECT_EQ(run({"--max-cuboids", "7", "--threads", "2"}), expected({.max_cuboids = 7}));
  EXPECT_EQ(run({"--preset", "exact", "--omega", "20", "--weight", "cells"}),
            expected({.outer = 0, .omega = 20, .max_false = std::nullopt}));
}

TEST_F(Approximate, gives_a_lower_bound_on_request) {
  build_room();
  rmap_json({"approximate", "room.rmap", "-o", "room.csv", "--preset", "exact"});
  const auto answer = rmap_json({"evaluate-cuboids", "room.rmap", "room.csv", "--lower-bound"});
  EXPECT_GT(answer["lower_bound"], 10);
  EXPECT_LE(answer["lower_bound"], answer["cuboids"]);
  EXPECT_THAT(
      rmap_done({"evaluate-cuboids", "room.rmap", "room.csv", "--lower-bound", "--steps", "1"}).out,
      HasSubstr("no list"));
  rmap_json({"approximate", "room.rmap", "-o", "room.csv", "--preset", "sketch"});
  EXPECT_THAT(rmap_refused(1, {"evaluate-cuboids", "room.rmap", "room.csv", "--lower-bound"}),
              HasSubstr("lose"));
}

TEST_F(Approximate, takes_clouds_and_folders_in_a_frame) {
  const Simulation room = make_simulation("tilted_room", {.scans = 4, .noise = 0.005});
  std::filesystem::create_directory(folder() / "scans");
  ScanFolderWriter writer(folder() / "scans");
  std::vector<Vector3f> points;
  for (const Scan& scan : room) {
    writer.add(scan);
    for (const Vector3f& point : scan.points) {
      points.push_back(transformed(scan.map_from_sensor, point).cast<float>());
    }
  }
  writer.finish();
  points.push_back(Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  write_points(folder() / "cloud.pcd", points);

  const std::vector<std::string> estimate{"--resolution", "0.1",     "--frame", "estimate",
                                          "--preset",     "compact", "--phase", "centre"};
  auto arguments = estimate;
  arguments.insert(arguments.begin(), {"approximate", "scans", "-o", "scans.rcs"});
  const auto of_scans = rmap_json(arguments);
  arguments = estimate;
  arguments.insert(arguments.begin(), {"approximate", "cloud.pcd", "-o", "cloud.rcs"});
  const auto of_cloud = rmap_json(arguments);
  EXPECT_EQ(of_scans["cuboids"], of_cloud["cuboids"]);
  EXPECT_EQ(of_cloud["not_finite"], 1);
  EXPECT_THAT(of_scans["why_frame"].get<std::string>(), HasSubstr("turned"));
  const auto straight = rmap_json(
      {"approximate", "scans", "-o", "plain.rcs", "--resolution", "0.1", "--preset", "compact"});
  EXPECT_LT(of_scans["cuboids"].get<int>(), straight["cuboids"].get<int>() / 2);

  // Evaluated in the frame that the file has.
  const auto evaluation = rmap_json({"evaluate-cuboids", "cloud.pcd", "scans.rcs"});
  EXPECT_EQ(evaluation["lost_cells"], 0);
  EXPECT_EQ(evaluation["farthest_false"], 1);

  // A frame can be given.
  const auto& given = of_scans["frame"]["rotation"];
  const auto quaternion = fmt::format("{},{},{},{}", given[0].get<double>(), given[1].get<double>(),
                                      given[2].get<double>(), given[3].get<double>());
  rmap_json({"approximate", "scans", "-o", "given.rcs", "--resolution", "0.1", "--frame",
             quaternion, "--preset", "compact"});
}

TEST_F(Approximate, writes_every_ending) {
  build_room();
  for (const char* ending :
       {".rcs", ".csv", ".json", ".ply", ".glb", ".urdf", ".sdf", ".xml", ".scene"}) {
    SCOPED_TRACE(ending);
    const std::string name = std::string("out") + ending;
    rmap_done({"approximate", "room.rmap", "-o", name, "--preset", "sketch"});
    EXPECT_GT(std::filesystem::file_size(folder() / name), 100u);
  }
}

TEST_F(Approximate, says_what_a_list_means) {
  build_room();
  const std::string compact =
      rmap_done({"approximate", "room.rmap", "-o", "out.rcs", "--preset", "compact"}).out;
  EXPECT_THAT(compact, HasSubstr("thicker by up to 1 cell"));
  EXPECT_THAT(compact, HasSubstr("keep their axes"));
}

TEST_F(Approximate, refuses_what_makes_no_sense) {
  build_room();
  const auto refused = [&](int code, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"approximate", "room.rmap", "-o", "out.rcs"});
    return rmap_refused(code, arguments);
  };
  EXPECT_THAT(refused(1, {"--outer", "4"}), HasSubstr("between 0 and 3"));
  EXPECT_THAT(refused(2, {"--outer", "0.5"}), HasSubstr("whole number"));
  EXPECT_THAT(refused(1, {"--sigma", "nan"}), HasSubstr("sigma"));
  EXPECT_THAT(refused(1, {"--sigma", "0"}), HasSubstr("sigma"));
  EXPECT_THAT(refused(1, {"--max-false", "1"}), HasSubstr("max_false"));
  EXPECT_THAT(refused(2, {"--omega", "0"}), HasSubstr("whole number"));
  EXPECT_THAT(refused(2, {"--preset", "tiny"}), HasSubstr("exact, default, compact, sketch"));
  EXPECT_THAT(refused(2, {"--method", "magic"}), HasSubstr("midpoint"));
  EXPECT_THAT(refused(2, {"--frame", "1,2,3"}), HasSubstr("quaternion"));
  EXPECT_THAT(refused(2, {"--frame", "0,0,0,0"}), HasSubstr("--frame"));
  EXPECT_THAT(refused(1, {"--frame", "0,0,0.5,0.5"}), HasSubstr("keep their axes"));
  EXPECT_THAT(refused(1, {"--resolution", "0.2"}), HasSubstr("resolution"));
  EXPECT_THAT(rmap_refused(1, {"approximate", "room.rmap", "-o", "out.stl"}),
              AllOf(HasSubstr("out.stl"), HasSubstr(".glb")));
  EXPECT_THAT(rmap_refused(1, {"approximate", "room.txt", "-o", "out.rcs"}), HasSubstr("room.txt"));
  EXPECT_THAT(rmap_refused(1, {"evaluate-cuboids", "room.rmap", "room.rmap"}),
              HasSubstr("room.rmap"));
  EXPECT_FALSE(std::filesystem::exists(folder() / "out.rcs"));
  EXPECT_THAT(listing(), testing::Not(testing::Contains(HasSubstr("out"))));
}

}  // namespace

}  // namespace rmap::test
