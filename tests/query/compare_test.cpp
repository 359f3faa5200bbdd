#include <rmap/compare.hpp>

#include <gtest/gtest.h>

#include <rmap/error.hpp>

#include "support/grids.hpp"

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

TEST(Compare, RefusesOtherResolutions) {
  EXPECT_THROW(compare(Grid({.resolution = 1}), Grid({.resolution = 2})), Error);
}

}  // namespace
}  // namespace rmap
