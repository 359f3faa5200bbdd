#include "command/command.hpp"
#include "support/random.hpp"

#include <gmock/gmock.h>

#include <rmap/cells.hpp>
#include <rmap/map_file.hpp>
#include <rmap/octomap_file.hpp>

namespace rmap::test {

namespace {

using testing::HasSubstr;

/// The verbs that take maps of OctoMap, on the files of a random map.
class Octomaps : public CommandTest {
 protected:
  Octomaps() : grid_({.resolution = 0.5}) {
    Random random(91);
    for (int i = 0; i < 300; ++i) grid_.set(random.cell(-10, 10), random.real(0.13, 0.97));
    save(grid_, folder() / "map.rmap");
    occupied_ = count_cells(grid_, {.occupied_only = true});
  }

  Grid grid_;
  std::size_t occupied_;
};

TEST_F(Octomaps, ConvertThereAndBack) {
  const auto written = rmap_json({"convert", "map.rmap", "map.ot"});
  EXPECT_EQ(written["cells"], grid_.cell_count());
  EXPECT_EQ(written["written"]["occupied_cells"], occupied_);
  EXPECT_EQ(written["written"]["changed_states"], 0);
  EXPECT_EQ(written["written"]["lost_values"], 0);
  EXPECT_FALSE(written.contains("read"));
  const auto read = rmap_json({"convert", "map.ot", "back.rmap", "--keep-free"});
  EXPECT_EQ(read["cells"], grid_.cell_count());
  EXPECT_EQ(read["read"]["id"], "OcTree");
  EXPECT_EQ(read["read"]["dropped_free_leaves"], 0);
  rmap_done({"compare", "map.rmap", "back.rmap", "--expect-equal"});

  EXPECT_EQ(rmap_json({"convert", "map.ot", "occupied.rmap"})["cells"], occupied_);
  EXPECT_GT(rmap_json({"convert", "map.rmap", "map.bt"})["written"]["lost_values"], 0);
  const auto states = rmap_json({"convert", "map.bt", "states.rmap", "--clamp-max", "0.9"});
  EXPECT_EQ(states["cells"], occupied_);
  EXPECT_EQ(states["read"]["states_only"], true);
  for (const auto& [cell, value] : cells(load(folder() / "states.rmap"))) {
    EXPECT_EQ(value, value_of(0.9));
  }
  // One form of OctoMap becomes the other, and rows for other programs.
  rmap_done({"convert", "map.ot", "again.bt", "--keep-free"});
  EXPECT_EQ(bytes("again.bt"), bytes("map.bt"));
  EXPECT_EQ(rmap_json({"convert", "map.bt", "map.csv"})["cells"], occupied_);
}

TEST_F(Octomaps, ConvertTellsWhatIsLost) {
  EXPECT_THAT(
      rmap_done({"convert", "map.rmap", "map.bt"}).out,
      testing::AllOf(HasSubstr("lost        options, history, values of "), HasSubstr("nodes")));
  EXPECT_THAT(rmap_done({"convert", "map.bt", "back.rmap"}).out,
              testing::AllOf(HasSubstr("--keep-free"), HasSubstr("states only")));
  EXPECT_THAT(rmap_refused(1, {"convert", "map.bt", "few.rmap", "--max-cells", "10"}),
              HasSubstr("--max-cells"));
  EXPECT_THAT(rmap_refused(1, {"approximate", "map.bt", "-o", "few.rcs", "--max-cells", "10"}),
              HasSubstr("--max-cells"));
  EXPECT_THAT(rmap_refused(2, {"convert", "map.rmap", "a.rmap", "--keep-free"}),
              HasSubstr("--keep-free has no effect"));
  EXPECT_THAT(rmap_refused(2, {"convert", "map.rmap", "a.ot", "--cells", "all"}),
              HasSubstr("--cells has no effect"));
  Grid far({.resolution = 0.5});
  far.set({40000, 0, 0}, 0.9);
  save(far, folder() / "far.rmap");
  EXPECT_THAT(rmap_refused(1, {"convert", "far.rmap", "far.ot"}), HasSubstr("(40000, 0, 0)"));
  EXPECT_THAT(listing(), testing::Not(testing::Contains("far.ot")));
}

TEST_F(Octomaps, InfoDescribesThem) {
  rmap_done({"convert", "map.rmap", "map.ot"});
  rmap_done({"convert", "map.rmap", "map.bt"});
  const auto both = rmap_json({"info", "map.ot", "map.bt"});
  for (const auto& info : both) {
    EXPECT_EQ(info["kind"], "octomap");
    EXPECT_EQ(info["id"], "OcTree");
    EXPECT_EQ(info["resolution"], 0.5);
    EXPECT_EQ(info["cells"]["occupied"], occupied_);
    EXPECT_EQ(info["cells"]["free"], grid_.cell_count() - occupied_);
    EXPECT_EQ(info["bounds"]["min"], numbers(grid_.lattice().metric(grid_.bounds()).min));
  }
  EXPECT_TRUE(both[0]["log_odds"]["max"].is_number());
  EXPECT_EQ(both[1]["log_odds"], nullptr);
  EXPECT_THAT(rmap_done({"info", "map.bt"}).out, HasSubstr("states only"));
}

TEST_F(Octomaps, CompareTakesThemOnEitherSide) {
  rmap_done({"convert", "map.rmap", "map.ot"});
  rmap_done({"compare", "map.rmap", "map.ot", "--keep-free", "--expect-equal"});
  rmap_done({"compare", "map.ot", "map.rmap", "--keep-free", "--expect-equal"});
  const auto occupied = rmap_json({"compare", "map.ot", "map.rmap"});
  EXPECT_EQ(occupied["cells"]["a"], occupied_);
  EXPECT_EQ(occupied["occupied_both"], occupied_);
  EXPECT_EQ(occupied["occupied_only_b"], 0);
}

TEST_F(Octomaps, OtherVerbsTakeThemOrSayHow) {
  rmap_done({"convert", "map.rmap", "map.ot"});
  rmap_done({"approximate", "map.ot", "-o", "a.rcs", "--preset", "exact"});
  rmap_done({"approximate", "map.rmap", "-o", "b.rcs", "--preset", "exact"});
  EXPECT_EQ(bytes("a.rcs"), bytes("b.rcs"));
  for (const std::vector<std::string>& call :
       {std::vector<std::string>{"query", "map.ot", "point", "0,0,0"},
        {"merge", "map.rmap", "map.ot", "-o", "c.rmap"}}) {
    EXPECT_THAT(rmap_refused(1, call), HasSubstr("`rmap convert map.ot MAP.rmap`"));
  }
}

}  // namespace

}  // namespace rmap::test
