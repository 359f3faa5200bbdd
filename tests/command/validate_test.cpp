#include "command/command.hpp"
#include "support/random.hpp"

#include <gmock/gmock.h>

#include <rmap/map_file.hpp>
#include <rmap/octomap_file.hpp>

namespace rmap::test {

namespace {

using testing::HasSubstr;
using testing::SizeIs;

class Validate : public CommandTest {
 protected:
  Validate() {
    Grid grid({.resolution = 0.5});
    Random random(92);
    for (int i = 0; i < 300; ++i) grid.set(random.cell(-10, 10), 0.9);
    save(grid, folder() / "map.rmap");
    export_octomap(grid, folder() / "map.bt");
    export_octomap(grid, folder() / "map.ot");
    simulate_room("room");
  }

  void damage(const std::string& name, std::size_t at) const {
    std::string damaged = bytes(name);
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write(name, damaged);
  }

  // The answer of a call that finds something.
  nlohmann::json problems(std::vector<std::string> files) const {
    files.insert(files.begin(), "validate");
    files.emplace_back("--json");
    const Outcome outcome = rmap(files);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("not sound"));
    return outcome.json();
  }
};

TEST_F(Validate, SoundFilesPass) {
  rmap_done({"approximate", "map.rmap", "-o", "map.rcs"});
  rmap_done({"approximate", "map.rmap", "-o", "map.csv"});
  const std::vector<std::string> files = {"map.rmap", "map.bt",        "map.ot",
                                          "map.rcs",  "map.csv",       "room/000000.bin",
                                          "room",     "room/poses.txt"};
  std::vector<std::string> call = {"validate"};
  call.insert(call.end(), files.begin(), files.end());
  const Outcome outcome = rmap_done(call);
  for (const std::string& file : files) EXPECT_THAT(outcome.out, HasSubstr(file + ": sound\n"));
  EXPECT_EQ(rmap_json({"validate", "map.rmap"})["sound"], true);
  EXPECT_THAT(rmap_json({"validate", "map.rmap"})["problems"], SizeIs(0));
}

TEST_F(Validate, EachDamagedChunkIsNamed) {
  damage("map.rmap", 80);                             // OPTS
  damage("map.rmap", bytes("map.rmap").size() - 60);  // CELL
  const auto answer = problems({"map.rmap"});
  EXPECT_EQ(answer["sound"], false);
  ASSERT_GE(answer["problems"].size(), 2u);
  EXPECT_EQ(answer["problems"][0]["chunk"], "OPTS");
  EXPECT_EQ(answer["problems"][0]["offset"], 48);
  EXPECT_EQ(answer["problems"][1]["chunk"], "CELL");
  const Outcome words = rmap({"validate", "map.rmap"});
  EXPECT_EQ(words.exit_code, 1);
  EXPECT_THAT(words.out, HasSubstr("the checksum of chunk OPTS at byte 48 does not fit"));
}

TEST_F(Validate, EachScanThatCannotBeReadIsNamed) {
  write("room/000000.bin", "seven77");
  write("room/000002.bin", "seven77");
  const auto answer = problems({"room"});
  ASSERT_EQ(answer["problems"].size(), 2u);
  EXPECT_THAT(answer["problems"][0]["sentence"].get<std::string>(), HasSubstr("000000.bin"));
  EXPECT_THAT(answer["problems"][1]["sentence"].get<std::string>(), HasSubstr("000002.bin"));
  write("room/poses.txt", "1 2 3\n");
  EXPECT_EQ(problems({"room"})["problems"].size(), 1u);
}

TEST_F(Validate, OneBadFileDoesNotHideTheNext) {
  write("map.bt", bytes("map.bt") + "x");
  write("map.ot", bytes("map.ot").substr(0, 200));
  const auto answer = problems({"missing.rmap", "map.bt", "map.rmap", "map.ot", "what.ever"});
  ASSERT_EQ(answer.size(), 5u);
  EXPECT_EQ(answer[0]["sound"], false);
  EXPECT_EQ(answer[1]["sound"], false);
  EXPECT_EQ(answer[2]["sound"], true);
  EXPECT_EQ(answer[3]["sound"], false);
  EXPECT_EQ(answer[4]["sound"], false);
  EXPECT_THAT(answer[1]["problems"][0]["sentence"].get<std::string>(),
              HasSubstr("1 bytes behind its last node"));
}

}  // namespace

}  // namespace rmap::test
