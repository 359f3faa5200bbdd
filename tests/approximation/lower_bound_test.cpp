#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include <gtest/gtest.h>

#include <rmap/approximate.hpp>
#include <rmap/cuboid_bound.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

bool fit(const CellSet& allowed, const Cell& a, const Cell& b) {
  return test::holds(allowed, united(box_of(a), box_of(b)));
}

/// As many cells as can be found of which no two fit into one box: asks all subsets.
std::size_t most_independent(const std::vector<Cell>& cells, const CellSet& allowed) {
  std::vector<std::uint32_t> fits(cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = 0; j < cells.size(); ++j) {
      if (i != j && fit(allowed, cells[i], cells[j])) fits[i] |= 1u << j;
    }
  }
  std::size_t most = 0;
  for (std::uint32_t subset = 0; subset < 1u << cells.size(); ++subset) {
    bool independent = true;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if ((subset >> i & 1) != 0) independent = independent && (subset & fits[i]) == 0;
    }
    if (independent) most = std::max(most, static_cast<std::size_t>(std::popcount(subset)));
  }
  return most;
}

TEST(LowerBound, IsSoundAndNeverAboveTheCuboids) {
  int compared = 0;
  Random random(1);
  SCOPED_TRACE(random.trace());
  for (const auto& [name, cells] : test::small_scenes(random)) {
    if (name == "far_clusters") continue;
    SCOPED_TRACE(name);
    const auto input = test::counted(cells, random, 3);
    const CellSet plain = test::set_of(cells);
    for (int outer = 0; outer <= 2; ++outer, ++compared) {
      const CuboidBoundOptions options{.outer = outer, .steps_per_cell = 5};
      const CuboidBound bound = lower_bound(input, options);
      ASSERT_TRUE(verify(bound, input, outer));
      ASSERT_EQ(lower_bound(input, options).independent, bound.independent);
      const CellSet allowed = test::dilated(plain, outer);
      for (std::size_t i = 0; i < bound.cuboids(); i += 7) {
        for (std::size_t j = 0; j < i; ++j) {
          ASSERT_FALSE(fit(allowed, bound.independent[i], bound.independent[j]));
        }
      }
      const auto result = approximate(
          input, {.method = CuboidMethod::cover, .outer = outer, .max_false = std::nullopt});
      ASSERT_LE(bound.cuboids(), result.cuboids.size());
      ASSERT_GE(bound.cuboids(), 1u);
    }
  }
  EXPECT_EQ(compared, 14 * 3);
}

TEST(LowerBound, ComesNearTheMostOfTinySets) {
  int compared = 0;
  std::size_t found = 0;
  std::size_t most = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed, ++compared) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    std::vector<Cell> cells = test::random_fill(random, 4, random.real(0.1, 0.3));
    if (cells.size() > 14) cells.resize(14);
    const int outer = random.integer(0, 1);
    const auto bound = lower_bound(test::counted(cells), {.outer = outer});
    const std::size_t best = most_independent(cells, test::dilated(test::set_of(cells), outer));
    ASSERT_LE(bound.cuboids(), best);
    found += bound.cuboids();
    most += best;
  }
  EXPECT_EQ(compared, 60);
  EXPECT_GE(static_cast<double>(found), 0.95 * static_cast<double>(most));
}

TEST(LowerBound, BadCertificatesAreRefused) {
  const auto cells = test::counted(test::hollow_box({{0, 0, 0}, {9, 8, 7}}));
  const CuboidBound good{{{0, 3, 3}, {8, 3, 3}, {4, 0, 3}}};
  EXPECT_TRUE(verify(good, cells, 0));
  EXPECT_TRUE(verify({}, cells, 0));
  const auto with = [&](const Cell& cell) {
    CuboidBound bound = good;
    bound.independent.push_back(cell);
    return bound;
  };
  EXPECT_TRUE(verify(with({4, 7, 3}), cells, 0));
  EXPECT_FALSE(verify(with({0, 3, 3}), cells, 0));  // twice
  EXPECT_FALSE(verify(with({4, 4, 4}), cells, 0));  // not occupied
  EXPECT_FALSE(verify(with({0, 5, 5}), cells, 0));  // fits with the first one
  EXPECT_TRUE(verify({{{0, 3, 3}, {1, 0, 3}}}, cells, 0));
  EXPECT_FALSE(verify({{{0, 3, 3}, {1, 0, 3}}}, cells, 1));  // fits where more is allowed
}

TEST(LowerBound, RandomPairsThatFitAreRefused) {
  int refused = 0;
  int accepted = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    const auto cells = test::random_fill(random, 7, random.real(0.3, 0.9));
    const int outer = random.integer(0, 1);
    const CellSet allowed = test::dilated(test::set_of(cells), outer);
    for (int pair = 0; pair < 40; ++pair) {
      const Cell a = cells[random.engine()() % cells.size()];
      const Cell b = cells[random.engine()() % cells.size()];
      if (a == b) continue;
      const bool good = !fit(allowed, a, b);
      ASSERT_EQ(verify({{a, b}}, test::counted(cells), outer), good);
      (good ? accepted : refused) += 1;
    }
  }
  EXPECT_GT(refused, 100);
  EXPECT_GT(accepted, 100);
}

TEST(LowerBound, OptionsAreChecked) {
  const std::vector<CountedCell> cells{{{1, 2, 3}, 1}};
  for (const int outer : {-1, 4}) EXPECT_THROW(lower_bound(cells, {.outer = outer}), Error);
  for (const double steps :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(lower_bound(cells, {.steps_per_cell = steps}), Error);
  }
  EXPECT_EQ(lower_bound(cells, {.outer = 3, .steps_per_cell = 0}).cuboids(), 1u);
}

TEST(LowerBound, EndsWhereTheGridWouldBeTooLarge) {
  EXPECT_TRUE(lower_bound({}).independent.empty());
  EXPECT_TRUE(verify({}, {}, 0));
  const std::vector<CountedCell> cells{{Cell::Constant(-3000), 1}, {Cell::Constant(3000), 1}};
  try {
    lower_bound(cells);
    FAIL() << "it was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::limit);
  }
}

}  // namespace
}  // namespace rmap
