// How `rmap build` and `rmap info` take scans that are no plain folder.
#include "command/command.hpp"
#include "support/bag_messages.hpp"
#include "support/bag_writer.hpp"

#include <cmath>

#include <gmock/gmock.h>

#include <rmap/map_file.hpp>

namespace rmap::test {

namespace {

using testing::HasSubstr;
using testing::Not;

constexpr std::int64_t kSecond = 1'000'000'000;

class Scans : public CommandTest {
 protected:
  std::vector<std::string> build(const std::string& scans, std::vector<std::string> options) const {
    options.insert(options.begin(), {"build", scans, "-o", "m.rmap", "--resolution", "0.5"});
    return options;
  }
  Grid map() const { return load(folder() / "m.rmap"); }
};

TEST_F(Scans, ALoneCloudHasToSayWhereItsBeamsBegan) {
  write("a.xyz", "1005.2 0.2 0.2\n1005.2 1.2 0.2\n");
  const Outcome refused = rmap(build("a.xyz", {}));
  EXPECT_EQ(refused.exit_code, 1);
  for (const std::string option : {"--sensor-origin", "--sensor-pose", "--end-points"}) {
    EXPECT_THAT(refused.err, HasSubstr(option));
  }

  rmap_done(build("a.xyz", {"--end-points"}));
  EXPECT_EQ(map().state({1005.2, 0.2, 0.2}), State::occupied);
  rmap_done(build("a.xyz", {"--sensor-origin", "1000,0,0", "--offset", "1000,0,0"}));
  EXPECT_EQ(map().state({5.2, 0.2, 0.2}), State::occupied);
  // Half a turn about z carries the point to the other side of the sensor.
  rmap_done(build("a.xyz", {"--sensor-pose", "0,0,0,0,0,1,0"}));
  EXPECT_EQ(map().state({-1005.2, -0.2, 0.2}), State::occupied);
  rmap_done(build("a.xyz", {"--sensor-pose", "0,0,0,0,0,0,1", "--quaternion", "wxyz"}));
  EXPECT_EQ(map().state({-1005.2, -0.2, 0.2}), State::occupied);
}

TEST_F(Scans, OptionsThatMakeNoSenseAreUsage) {
  write("a.xyz", "1 2 3\n");
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--sensor-pose", "1,2,3"},
                                             {"--sensor-pose", "0,0,0,0,0,0,0"},
                                             {"--sensor-origin", "1,2"},
                                             {"--frame", "moon"},
                                             {"--quaternion", "zyx"},
                                             {"--no-return", "far"}}) {
    const Outcome outcome = rmap(build("a.xyz", options));
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(options.front()));
  }
}

TEST_F(Scans, CoarseCoordinatesGetANote) {
  write("a.xyz", "1 2 5648349.8\n");
  const auto coarse = rmap_done(build("a.xyz", {"--end-points"}));
  EXPECT_THAT(coarse.out, HasSubstr("note"));
  EXPECT_THAT(coarse.out, HasSubstr("in steps of 0.5 m"));
  const auto fine = rmap_done(build("a.xyz", {"--end-points", "--offset", "0,0,5648000"}));
  EXPECT_THAT(fine.out, Not(HasSubstr("note")));
}

TEST_F(Scans, OtherColumnsAndDirectionsWithoutReturn) {
  std::string bytes;
  for (const std::vector<float>& point :
       std::vector<std::vector<float>>{{4, 0, 0, 1, 7}, {0, 9, 0, 1, 8}}) {
    for (const float number : point) {
      bytes.append(reinterpret_cast<const char*>(&number), sizeof(number));
    }
  }
  std::filesystem::create_directory(folder() / "scans");
  write("scans/0.bin", bytes);
  write("scans/poses.txt", "1 0 0 0.1 0 1 0 0.1 0 0 1 0.1\n");
  const auto answer =
      rmap_done(build("scans", {"--columns", "x,y,z,intensity,ring", "--no-return", "9", "--json"}))
          .json();
  EXPECT_EQ(answer["inserted"], 1);
  EXPECT_EQ(answer["cut"], 1);
  EXPECT_EQ(rmap(build("scans", {})).exit_code, 1);
}

TEST_F(Scans, AMapOfNothingIsNotWritten) {
  write("a.xyz", "nan 0 0\n");
  write("m.rmap", "the map before");
  const Outcome nothing = rmap(build("a.xyz", {"--end-points"}));
  EXPECT_EQ(nothing.exit_code, 1);
  EXPECT_THAT(nothing.err, HasSubstr("none of the 1 point of 1 scan has an effect"));
  EXPECT_EQ(bytes("m.rmap"), "the map before");
}

TEST_F(Scans, ConversionKeepsTheInputAndTheKindOfTheOutput) {
  simulate_room("room");
  rmap_done(build("room", {}));
  const std::string before = bytes("m.rmap");
  const Outcome same = rmap({"convert", "m.rmap", "./m.rmap", "--prune", "0.9"});
  EXPECT_EQ(same.exit_code, 1);
  EXPECT_THAT(same.err, HasSubstr("both input and output"));
  EXPECT_EQ(bytes("m.rmap"), before);
  const Outcome map = rmap({"convert", "room", "room.rmap"});
  EXPECT_EQ(map.exit_code, 1);
  EXPECT_THAT(map.err, HasSubstr("`rmap build` makes maps of scans"));
  // Scans of any form become a folder.
  write("a.xyz", "1005648349.5 2 3\n");
  EXPECT_THAT(rmap_done({"convert", "a.xyz", "a.pcd"}).out, HasSubstr("--offset"));
  EXPECT_THAT(rmap_done({"convert", "a.xyz", "b.pcd", "--offset", "1005648349,0,0"}).out,
              Not(HasSubstr("--offset")));
  EXPECT_THAT(rmap_done({"info", "a.xyz"}).out, HasSubstr("in steps of"));
}

TEST_F(Scans, BagsSayWhatToTypeNext) {
  TestBag bag;
  for (int i = 0; i < 3; ++i) {
    const std::int64_t stamp = i * kSecond;
    if (i < 2) {
      bag.add("/tf", "tf2_msgs/msg/TFMessage", stamp,
              transforms_message({{.stamp = stamp,
                                   .parent = "odom",
                                   .child = "lidar",
                                   .translation = {static_cast<double>(i), 0, 0}}}));
    }
    const std::vector<Vector3f> points = {{3, 0.2F, 0.2F}, {std::nanf(""), 0, 0}};
    bag.add("/points", "sensor_msgs/msg/PointCloud2", stamp, cloud_of(points, stamp).message());
  }
  bag.add("/bell\a", "std_msgs/msg/String", 0, "");
  write("drive.mcap", mcap_bytes(bag));
  const Outcome info = rmap_done({"info", "drive.mcap"});
  EXPECT_THAT(info.out, HasSubstr("rmap build drive.mcap -o map.rmap --resolution 0.1"));
  EXPECT_THAT(info.out, HasSubstr("/bell\\x07"));
  EXPECT_THAT(info.out, Not(HasSubstr("\a")));
  EXPECT_EQ(rmap_json({"info", "drive.mcap"})["kind"], "bag");

  const auto answer = rmap_done(build("drive.mcap", {"--json"})).json();
  EXPECT_EQ(answer["scans"], 2);
  EXPECT_EQ(answer["scans_without_pose"], 1);
  EXPECT_EQ(answer["skipped"]["not_finite"], 2);
  EXPECT_EQ(map().state({4.2, 0.2, 0.2}), State::occupied);
  const auto later = rmap_done(build("drive.mcap", {"--from", "1", "--json"})).json();
  EXPECT_EQ(later["scans"], 1);
  // A recording that was cut off is read as far as it goes, with a warning.
  write("cut.mcap", mcap_bytes(bag, {.messages_per_chunk = 0}).substr(0, 1200));
  EXPECT_THAT(rmap_done({"info", "cut.mcap"}).out, HasSubstr("warning"));
  EXPECT_EQ(rmap({"validate", "cut.mcap"}).exit_code, 1);
}

}  // namespace

}  // namespace rmap::test
