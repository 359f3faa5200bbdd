#include "command/command.hpp"
#include "support/random.hpp"

#include <gmock/gmock.h>

#include <rmap/map_file.hpp>

namespace rmap::test {

namespace {

using testing::HasSubstr;

class Repair : public CommandTest {
 protected:
  // Two chunks of cells: blocks beyond the 4096 that one can hold.
  Repair() : grid_({.resolution = 0.5}) {
    for (int i = 0; i < 5000; ++i) grid_.set({8 * i, 0, 0}, 0.9);
    grid_.restore(History::complete, {});
    save(grid_, folder() / "map.rmap");
    sound_ = bytes("map.rmap");
  }

  void damage(std::size_t at) const {
    std::string damaged = sound_;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    write("map.rmap", damaged);
  }

  Grid grid_;
  std::string sound_;
};

TEST_F(Repair, SalvagesWhatIsSound) {
  damage(500);  // in the first chunk of cells
  const auto answer = rmap_json({"repair", "map.rmap", "new.rmap"});
  EXPECT_EQ(answer["salvaged"]["cells"], 5000 - 4096);
  EXPECT_EQ(answer["announced"]["cells"], 5000);
  EXPECT_EQ(answer["history"], "first_hit");
  EXPECT_EQ(answer["history_lost"], true);
  EXPECT_EQ(answer["options_lost"], false);
  const Grid repaired = load(folder() / "new.rmap");
  EXPECT_EQ(repaired.cell_count(), 5000u - 4096);
  EXPECT_EQ(repaired.options(), grid_.options());
  rmap_done({"validate", "new.rmap"});
  EXPECT_THAT(rmap_done({"repair", "map.rmap", "new.rmap"}).out,
              testing::AllOf(HasSubstr("904 of 5,000 cells"), HasSubstr("chunk CELL")));
}

TEST_F(Repair, ASoundMapStaysAsItIs) {
  EXPECT_THAT(rmap_done({"repair", "map.rmap", "new.rmap"}).out, HasSubstr("nothing was wrong"));
  EXPECT_EQ(bytes("new.rmap"), sound_);
}

TEST_F(Repair, NeedsAResolutionWithoutOptions) {
  damage(80);
  EXPECT_THAT(rmap_refused(1, {"repair", "map.rmap", "new.rmap"}), HasSubstr("--resolution"));
  EXPECT_THAT(listing(), testing::ElementsAre("map.rmap"));
  const auto answer = rmap_json({"repair", "map.rmap", "new.rmap", "--resolution", "0.5"});
  EXPECT_EQ(answer["options_lost"], true);
  EXPECT_EQ(load(folder() / "new.rmap").cell_count(), 5000u);
}

TEST_F(Repair, RefusesWhatMakesNoSense) {
  EXPECT_THAT(rmap_refused(1, {"repair", "map.rmap", "map.rmap"}), HasSubstr("the input too"));
  EXPECT_THAT(rmap_refused(1, {"repair", "map.rmap", "new.ot"}), HasSubstr(".rmap"));
  write("other.rmap", "ply\n");
  EXPECT_THAT(rmap_refused(1, {"repair", "other.rmap", "new.rmap"}), HasSubstr("not an rmap file"));
  EXPECT_THAT(rmap_refused(1, {"repair", "missing.rmap", "new.rmap"}), HasSubstr("missing.rmap"));
}

}  // namespace

}  // namespace rmap::test
