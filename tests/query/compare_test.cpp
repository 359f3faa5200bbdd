#include "support/grids.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include <rmap/compare.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

TEST(Compare, CountsEachKindOfDifference) {
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    Grid a({.resolution = 1});
    Grid b({.resolution = 1, .layout = layout});
    a.set({0, 0, 0}, 0.9);  // only in a, occupied
    a.set({1, 0, 0}, 0.2);  // only in a
    b.set({2, 0, 0}, 0.9);  // only in b, occupied
    a.set({3, 0, 0}, 0.9);  // the same in both
    b.set({3, 0, 0}, 0.9);
    a.set({4, 0, 0}, 0.9);  // another value, the same state
    b.set({4, 0, 0}, 0.8);
    a.set({5, 0, 0}, 0.7);  // another state
    b.set({5, 0, 0}, 0.2);
    const MapDifference difference = compare(a, b);
    EXPECT_EQ(difference.both, 3u);
    EXPECT_EQ(difference.only_a, 2u);
    EXPECT_EQ(difference.only_b, 1u);
    EXPECT_EQ(difference.occupied_both, 2u);
    EXPECT_EQ(difference.occupied_only_a, 2u);
    EXPECT_EQ(difference.occupied_only_b, 1u);
    EXPECT_EQ(difference.state_differs, 1u);
    EXPECT_EQ(difference.value_differs, 2u);
    EXPECT_NEAR(difference.max_difference, 0.5, 1e-3);
    EXPECT_FALSE(difference.same_cells());
  }
}

TEST(Compare, OfEqualMapsFindsNothing) {
  test::Random random(37);
  SCOPED_TRACE(random.trace());
  const Grid a = test::clustered_grid(random, {.resolution = 0.5}, 20);
  Grid b({.resolution = 0.5, .layout = Layout::cells});
  b.merge(a);
  const MapDifference difference = compare(a, b);
  EXPECT_TRUE(difference.same_cells());
  EXPECT_EQ(difference.both, a.cell_count());
  EXPECT_EQ(difference.max_difference, 0);
  EXPECT_EQ(test::map_hash(a), test::map_hash(b));
  b.set({0, 0, 0}, 0.51);
  EXPECT_FALSE(compare(a, b).same_cells());
  EXPECT_NE(test::map_hash(a), test::map_hash(b));
}

TEST(CompareWithCloud, CountsWhereEachPointLies) {
  test::Random random(86);
  SCOPED_TRACE(random.trace());
  for (const Layout layout : {Layout::blocks, Layout::cells}) {
    const Grid grid = test::clustered_grid(random, {.resolution = 0.5, .layout = layout}, 8);
    std::vector<Vector3f> points;
    for (int i = 0; i < 3000; ++i) points.push_back(random.point(-6, 6).cast<float>());
    CloudComparison expected{.points = 3002, .not_finite = 1, .beyond_limits = 1};
    for (const Vector3f& point : points) {
      const State state = grid.state(point.cast<double>());
      ++(state == State::occupied ? expected.in_occupied
         : state == State::free   ? expected.in_free
                                  : expected.in_assumed_free);
    }
    for (const CellValue& entry : test::all_cell_values(grid)) {
      const bool met = std::any_of(points.begin(), points.end(), [&](const Vector3f& point) {
        return grid.lattice().cell_of(point.cast<double>()) == entry.cell;
      });
      if (met) continue;
      ++expected.cells_without_point;
      expected.occupied_without_point += grid.rule().occupied(entry.value) ? 1 : 0;
    }
    points.emplace_back(std::numeric_limits<float>::quiet_NaN(), 0, 0);
    points.emplace_back(3e38F, 0, 0);
    const CloudComparison found = compare_with_cloud(grid, points);
    EXPECT_EQ(found.points, expected.points);
    EXPECT_EQ(found.not_finite, expected.not_finite);
    EXPECT_EQ(found.beyond_limits, expected.beyond_limits);
    EXPECT_EQ(found.in_occupied, expected.in_occupied);
    EXPECT_EQ(found.in_free, expected.in_free);
    EXPECT_EQ(found.in_assumed_free, expected.in_assumed_free);
    EXPECT_EQ(found.cells_without_point, expected.cells_without_point);
    EXPECT_EQ(found.occupied_without_point, expected.occupied_without_point);
    EXPECT_GT(found.in_occupied, 50u);
    EXPECT_GT(found.occupied_without_point, 20u);
  }
}

TEST(Compare, RefusesOtherResolutions) {
  EXPECT_THROW(compare(Grid({.resolution = 1}), Grid({.resolution = 2})), Error);
}

}  // namespace
}  // namespace rmap
