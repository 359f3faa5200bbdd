#include "command/command.hpp"
#include "support/random.hpp"

#include <array>
#include <set>

#include <gmock/gmock.h>

#include <rmap/cells.hpp>
#include <rmap/compare.hpp>
#include <rmap/map_file.hpp>
#include <rmap/scan_files.hpp>

namespace rmap::test {

namespace {

class Compare : public CommandTest {
 protected:
  Compare() : random_(73), a_({.resolution = 0.5}), b_({.resolution = 0.5}) {
    for (int i = 0; i < 300; ++i) {
      const Cell cell = random_.cell(-5, 5);
      if (random_.chance(0.7)) a_.set(cell, random_.real(0.2, 0.9));
      if (random_.chance(0.7)) b_.set(cell, random_.real(0.2, 0.9));
    }
    save(a_, folder() / "a.rmap");
    save(b_, folder() / "b.rmap");
  }

  Random random_;
  Grid a_;
  Grid b_;
};

TEST_F(Compare, TwoMaps) {
  SCOPED_TRACE(random_.trace());
  const MapDifference expected = compare(a_, b_);
  ASSERT_GT(expected.only_a, 0u);
  ASSERT_GT(expected.value_differs, 0u);
  const auto answer = rmap_json({"compare", "a.rmap", "b.rmap"});
  EXPECT_EQ(answer["cells"]["a"], a_.cell_count());
  EXPECT_EQ(answer["cells"]["b"], b_.cell_count());
  EXPECT_EQ(answer["both"], expected.both);
  EXPECT_EQ(answer["only_a"], expected.only_a);
  EXPECT_EQ(answer["only_b"], expected.only_b);
  EXPECT_EQ(answer["occupied_both"], expected.occupied_both);
  EXPECT_EQ(answer["occupied_only_a"], expected.occupied_only_a);
  EXPECT_EQ(answer["occupied_only_b"], expected.occupied_only_b);
  EXPECT_EQ(answer["state_differences"], expected.state_differs);
  EXPECT_EQ(answer["value_differences"], expected.value_differs);
  EXPECT_EQ(answer["max_difference"], expected.max_difference);
  EXPECT_EQ(answer["equal"], false);
  EXPECT_EQ(answer["same_map"], false);
}

TEST_F(Compare, ExpectEqualDecidesTheExitCode) {
  rmap_done({"compare", "a.rmap", "b.rmap"});
  EXPECT_THAT(rmap_refused(1, {"compare", "a.rmap", "b.rmap", "--expect-equal"}),
              testing::HasSubstr("not equal"));
  rmap_done({"compare", "a.rmap", "a.rmap", "--expect-equal"});
}

TEST_F(Compare, EqualCellsNeedNotBeTheSameMap) {
  Grid other({.resolution = 0.5, .prob_hit = 0.9});
  for (const auto& [cell, value] : cells(a_)) other.set_value(cell, value);
  save(other, folder() / "other.rmap");
  const auto answer = rmap_json({"compare", "a.rmap", "other.rmap"});
  EXPECT_EQ(answer["equal"], true);
  EXPECT_EQ(answer["same_map"], false);
}

TEST_F(Compare, AMapAndACloud) {
  SCOPED_TRACE(random_.trace());
  std::vector<Vector3f> points;
  for (int i = 0; i < 500; ++i) points.push_back(random_.point(-3, 3).cast<float>());
  points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0, 0);
  points.emplace_back(3e38F, 0, 0);
  write_points(folder() / "cloud.bin", points);

  std::size_t in_occupied = 0;
  std::size_t in_free = 0;
  std::size_t in_assumed_free = 0;
  std::set<std::array<int, 3>> seen;
  std::set<std::array<int, 3>> seen_occupied;
  for (std::size_t i = 0; i < 500; ++i) {
    const Cell cell = a_.lattice().cell_of(points[i].cast<double>());
    const State state = a_.cell_state(cell);
    (state == State::occupied ? in_occupied : state == State::free ? in_free : in_assumed_free)++;
    if (state == State::assumed_free) continue;
    seen.insert({cell.x(), cell.y(), cell.z()});
    if (state == State::occupied) seen_occupied.insert({cell.x(), cell.y(), cell.z()});
  }
  const auto answer = rmap_json({"compare", "a.rmap", "cloud.bin"});
  EXPECT_EQ(answer["points"], 502);
  EXPECT_EQ(answer["not_finite"], 1);
  EXPECT_EQ(answer["beyond_limits"], 1);
  EXPECT_EQ(answer["in_occupied"], in_occupied);
  EXPECT_EQ(answer["in_free"], in_free);
  EXPECT_EQ(answer["in_assumed_free"], in_assumed_free);
  EXPECT_EQ(answer["cells_without_point"], a_.cell_count() - seen.size());
  EXPECT_EQ(answer["occupied_without_point"],
            count_cells(a_, {.occupied_only = true}) - seen_occupied.size());
}

}  // namespace

}  // namespace rmap::test
