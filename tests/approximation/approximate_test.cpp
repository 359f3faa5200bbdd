#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/approximate.hpp>
#include <rmap/cuboid_bound.hpp>
#include <rmap/cuboid_error.hpp>
#include <rmap/cuboid_map.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

constexpr CuboidMethod kMethods[] = {CuboidMethod::automatic, CuboidMethod::cover,
                                     CuboidMethod::split, CuboidMethod::runs,
                                     CuboidMethod::midpoint};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// Options of every method and preset.
std::vector<ApproximationOptions> many_options() {
  std::vector<ApproximationOptions> all;
  for (const char* preset : {"exact", "default", "compact", "sketch"}) {
    all.push_back(approximation_preset(preset));
  }
  for (const CuboidMethod method : kMethods) {
    all.push_back({.method = method});
    all.push_back(
        {.method = method, .weight = CuboidWeight::points, .max_false = 0.4, .fill = 0.5});
  }
  all.push_back({.method = CuboidMethod::split, .outer = 0, .max_false = 0.5});
  all.push_back({.method = CuboidMethod::split, .outer = 2, .max_false = 0.5});
  all.push_back({.outer = std::nullopt, .max_false = 0.5});
  all.push_back({.outer = 1, .inner = 1, .max_false = 0.2});
  return all;
}

std::size_t cells_near(const CellSet& cells, std::span<const Cuboid> cuboids, int inner) {
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), [&](const Cell& cell) {
    return std::any_of(cuboids.begin(), cuboids.end(), [&](const Cuboid& cuboid) {
      return test::grown(cuboid.cells, inner).contains(cell);
    });
  }));
}

TEST(Approximate, RefusesEachOptionOutOfRange) {
  using Options = ApproximationOptions;
  using Change = std::function<void(Options&)>;
  const std::vector<std::pair<std::string, Change>> changes{
      {"outer", [](Options& o) { o.outer = -1; }},
      {"outer", [](Options& o) { o.outer = 4; }},
      {"inner", [](Options& o) { o.inner = -1; }},
      {"inner", [](Options& o) { o.inner = 4; }},
      {"sigma", [](Options& o) { o.sigma = 0; }},
      {"sigma", [](Options& o) { o.sigma = 1.01; }},
      {"sigma", [](Options& o) { o.sigma = kNan; }},
      {"fill", [](Options& o) { o.fill = 0; }},
      {"fill", [](Options& o) { o.fill = 1.5; }},
      {"fill", [](Options& o) { o.fill = kNan; }},
      {"omega", [](Options& o) { o.omega = 0; }},
      {"max_false", [](Options& o) { o.max_false = -0.1; }},
      {"max_false", [](Options& o) { o.max_false = 1; }},
      {"max_false", [](Options& o) { o.max_false = kNan; }},
      {"threads", [](Options& o) { o.threads = -1; }},
      {"threads", [](Options& o) { o.threads = 1025; }},
  };
  for (const auto& [name, change] : changes) {
    ApproximationOptions options;
    change(options);
    try {
      approximate({}, options);
      ADD_FAILURE() << name << " was taken";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_THAT(error.what(), testing::StartsWith(name + " is "));
    }
  }
}

TEST(Approximate, RefusesCellsThatNoMapHas) {
  constexpr std::int32_t kEnds[] = {std::numeric_limits<std::int32_t>::min(), kMinCellIndex - 1,
                                    kMaxCellIndex + 1, std::numeric_limits<std::int32_t>::max()};
  for (const std::int32_t end : kEnds) {
    const std::vector<CountedCell> cells{{{0, 0, 0}, 1}, {{0, end, 0}, 1}};
    for (const CuboidMethod method : kMethods) {
      EXPECT_THROW(approximate(cells, {.method = method}), Error);
    }
    EXPECT_THROW(CuboidMap{cells}, Error);
    EXPECT_THROW(lower_bound(cells), Error);
    EXPECT_THROW(cuboid_error(cells, {}), Error);
  }
  EXPECT_THROW(approximate(std::vector<CountedCell>{{{0, 0, 0}, 0}}), Error);
}

TEST(Approximate, PresetsHaveNames) {
  EXPECT_THROW(approximation_preset("coarse"), Error);
  const ApproximationOptions exact = approximation_preset("exact");
  EXPECT_EQ(exact.outer, 0);
  EXPECT_EQ(exact.sigma, 1);
  EXPECT_EQ(approximation_preset("compact").outer, 1);
  EXPECT_EQ(approximation_preset("default").max_false, 0.25);
  EXPECT_EQ(approximation_preset("sketch").outer, 2);
  EXPECT_EQ(approximation_preset("sketch").inner, 1);
}

TEST(Approximate, KeepsWhatEachMethodPromises) {
  int compared = 0;
  Random random(1);
  SCOPED_TRACE(random.trace());
  for (const auto& [name, cells] : test::small_scenes(random)) {
    SCOPED_TRACE(name);
    const CellSet plain = test::set_of(cells);
    const auto input = test::counted(cells, random, 4);
    for (const ApproximationOptions& options : many_options()) {
      const Approximation result = approximate(input, options);
      const ApproximationReport& report = result.report;
      SCOPED_TRACE(static_cast<int>(report.method));
      const auto boxes = test::boxes_of(result.cuboids);
      ASSERT_NE(report.method, CuboidMethod::automatic);
      ASSERT_FALSE(report.why.empty());
      const bool cover = report.method == CuboidMethod::cover;
      if (options.sigma == 1) {
        const bool midpoint = report.method == CuboidMethod::midpoint;
        const int outer = report.method == CuboidMethod::runs ? 0 : options.outer.value_or(1000);
        if (outer < 1000 && !midpoint) {
          ASSERT_EQ(test::violation(plain, boxes, outer, cover ? options.inner : 0), "");
        }
        if (options.max_false && !midpoint) {
          ASSERT_LE(cuboid_error(input, result.cuboids).false_share(), *options.max_false + 1e-12);
        }
        ASSERT_EQ(cells_near(plain, result.cuboids, cover ? options.inner : 0), plain.size());
        ASSERT_EQ(report.covered, report.weight);
      }
      // Of midpoint `fill` decides.
      if (options.max_false && report.method != CuboidMethod::midpoint) {
        const CellSet volume = test::union_of(boxes);
        ASSERT_LE(static_cast<double>(volume.size()) - static_cast<double>(cells.size()),
                  *options.max_false * static_cast<double>(volume.size()));
      }
      std::uint64_t points = 0;
      for (const CountedCell& entry : input) points += entry.points;
      ASSERT_EQ(report.cells, cells.size());
      ASSERT_EQ(report.points, points);
      ASSERT_EQ(report.weight, options.weight == CuboidWeight::cells ? cells.size() : points);
      ASSERT_GE(static_cast<double>(report.covered),
                options.omega > 1 ? 0 : options.sigma * static_cast<double>(report.weight));
      for (const Cuboid& cuboid : result.cuboids) {
        std::uint64_t inside = 0;
        for (const auto& [cell, count] : input) inside += cuboid.cells.contains(cell) ? count : 0;
        ASSERT_EQ(cuboid.points, inside);
        ASSERT_TRUE(all_cells().contains(cuboid.cells));
      }
      ++compared;
    }
  }
  EXPECT_EQ(compared, 15 * 18);
}

TEST(Approximate, ExactOnesAreExactAndStaySo) {
  int compared = 0;
  Random random(2);
  SCOPED_TRACE(random.trace());
  for (const auto& [name, cells] : test::small_scenes(random)) {
    SCOPED_TRACE(name);
    const ApproximationOptions exact = approximation_preset("exact");
    const auto cuboids = approximate(test::counted(cells), exact).cuboids;
    const CellSet volume = test::union_of(test::boxes_of(cuboids));
    ASSERT_EQ(volume, test::set_of(cells));
    const std::vector<Cell> again(volume.begin(), volume.end());
    ASSERT_EQ(approximate(test::counted(again), exact).cuboids, cuboids);
    ++compared;
  }
  EXPECT_EQ(compared, 15);
}

TEST(Approximate, OrderRepetitionThreadsAndPlaceDoNotMatter) {
  int compared = 0;
  Random random(3);
  SCOPED_TRACE(random.trace());
  for (const auto& [name, cells] : test::small_scenes(random)) {
    SCOPED_TRACE(name);
    const auto input = test::counted(cells, random, 3);
    std::vector<CountedCell> other;
    for (const auto& [cell, points] : input) {
      for (std::uint32_t i = 0; i < points; ++i) other.push_back({cell, 1});
    }
    std::shuffle(other.begin(), other.end(), random.engine());
    const bool at_limit = name.ends_with("indices");
    const Cell by = at_limit ? Cell::Zero().eval() : random.cell(-50000, 50000);
    std::vector<CountedCell> moved = input;
    for (CountedCell& entry : moved) entry.cell += by;
    for (ApproximationOptions options : many_options()) {
      auto expected = approximate(input, options).cuboids;
      options.threads = 3;
      ASSERT_EQ(approximate(other, options).cuboids, expected);
      for (Cuboid& cuboid : expected) {
        cuboid.cells = {.min = cuboid.cells.min + by, .max = cuboid.cells.max + by};
      }
      ASSERT_EQ(approximate(moved, options).cuboids, expected);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 15 * 18);
}

bool is_prefix(const std::vector<Cuboid>& shorter, const std::vector<Cuboid>& longer) {
  return shorter.size() <= longer.size() &&
         std::equal(shorter.begin(), shorter.end(), longer.begin());
}

TEST(Approximate, ShorterListsArePrefixes) {
  int compared = 0;
  Random random(4);
  SCOPED_TRACE(random.trace());
  for (const auto& [name, cells] : test::small_scenes(random)) {
    SCOPED_TRACE(name);
    const auto input = test::counted(cells, random, 6);
    for (ApproximationOptions options : many_options()) {
      options.sigma = 1;
      options.omega = 1;
      const auto all = approximate(input, options);
      ASSERT_EQ(all.report.cut, 0u);
      std::uint64_t weight = 0;
      for (const double sigma : {0.05, 0.3, 0.5, 0.77, 0.95, 0.999}) {
        ApproximationOptions some = options;
        some.sigma = sigma;
        const auto part = approximate(input, some);
        ASSERT_TRUE(is_prefix(part.cuboids, all.cuboids));
        const double wanted = sigma * static_cast<double>(part.report.weight);
        ASSERT_GE(static_cast<double>(part.report.covered), wanted);
        ASSERT_GE(part.report.covered, weight);
        ASSERT_EQ(part.report.cut, all.cuboids.size() - part.cuboids.size());
        weight = part.report.covered;
        // It ends as soon as it may.
        ApproximationOptions less = options;
        less.max_cuboids = part.cuboids.size() - 1;
        const auto shorter = approximate(input, less);
        ASSERT_EQ(shorter.cuboids.size(), less.max_cuboids);
        ASSERT_TRUE(is_prefix(shorter.cuboids, part.cuboids));
        ASSERT_LT(static_cast<double>(shorter.report.covered), wanted);
        ++compared;
      }
      std::uint64_t covered = 0;
      for (std::size_t length = 0; length < all.cuboids.size() && length < 20; ++length) {
        ApproximationOptions less = options;
        less.max_cuboids = length + 1;
        const std::uint64_t now = approximate(input, less).report.covered;
        const std::uint64_t gain = now - covered;
        covered = now;
        less.max_cuboids = std::numeric_limits<std::size_t>::max();
        less.omega = gain;  // and what adds less is left out
        ASSERT_GE(approximate(input, less).cuboids.size(), length + 1);
        less.omega = gain + 1;
        ASSERT_LE(approximate(input, less).cuboids.size(), length);
        if (length > 2) break;
      }
    }
  }
  EXPECT_EQ(compared, 15 * 18 * 6);
}

TEST(Approximate, NothingAndOneCell) {
  for (const ApproximationOptions& options : many_options()) {
    const Approximation none = approximate({}, options);
    EXPECT_TRUE(none.cuboids.empty());
    EXPECT_EQ(none.report.cells, 0u);
    EXPECT_EQ(none.report.covered, 0u);
    ApproximationOptions all = options;
    all.omega = 1;
    const Cell cell(-5, 6, 7);
    const auto one = approximate(std::vector<CountedCell>{{cell, 9}}, all).cuboids;
    ASSERT_EQ(one.size(), 1u);
    EXPECT_TRUE(one.front().cells.contains(cell));
    EXPECT_EQ(one.front().points, 9u);
  }
}

TEST(Approximate, ReachesFromLimitToLimit) {
  std::vector<Cell> cells;
  for (int corner = 0; corner < 8; ++corner) {
    const auto end = [&](int axis) {
      return (corner >> axis & 1) != 0 ? kMaxCellIndex : kMinCellIndex;
    };
    cells.emplace_back(end(0), end(1), end(2));
  }
  cells.push_back(Cell::Zero());
  for (ApproximationOptions options : many_options()) {
    options.omega = 1;
    options.sigma = 1;
    const auto cuboids = approximate(test::counted(cells), options).cuboids;
    ASSERT_EQ(cuboids.size(), cells.size());
    EXPECT_EQ(cells_near(test::set_of(cells), cuboids, 0), cells.size());
    for (const Cuboid& cuboid : cuboids) {
      EXPECT_EQ(cuboid.points, 1u);
      EXPECT_LE(cuboid.cells.extent().maxCoeff(), 5);
    }
  }
}

}  // namespace
}  // namespace rmap
