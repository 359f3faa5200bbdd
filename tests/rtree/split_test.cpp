#include "rtree/split.hpp"

#include "rtree/boxes.hpp"
#include "rtree/plain_tree.hpp"

#include <algorithm>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Data;
using test::Random;

std::vector<bool> parts(const std::vector<CellBox>& boxes, int min_branches, Split split) {
  const Partition second = partition(boxes, min_branches, split);
  std::vector<bool> in_second(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) in_second[i] = second[i];
  return in_second;
}

CellBox cube(int x, int y, int z) { return box_of({x, y, z}); }

TEST(Split, PartsTwoClusters) {
  const std::vector<CellBox> boxes = {cube(0, 0, 0), cube(50, 0, 0), cube(1, 1, 0), cube(51, 1, 1),
                                      cube(2, 0, 0)};
  const std::vector<bool> expected = {false, true, false, true, false};
  EXPECT_EQ(parts(boxes, 2, Split::quadratic), expected);
  EXPECT_EQ(parts(boxes, 2, Split::linear), expected);
}

TEST(Split, AGroupThatWouldStarveGetsAllTheRest) {
  // The far box is a seed and nothing wants to join it.
  const std::vector<CellBox> boxes = {cube(0, 0, 0), cube(1, 0, 0), cube(2, 0, 0), cube(3, 0, 0),
                                      cube(999, 0, 0)};
  EXPECT_EQ(parts(boxes, 1, Split::quadratic),
            (std::vector<bool>{false, false, false, false, true}));
  const auto second = parts(boxes, 2, Split::quadratic);
  EXPECT_EQ(std::count(second.begin(), second.end(), true), 2);
}

TEST(Split, QuadraticSeedsAreThePairThatWastesMost) {
  // Two long flat boxes that cross waste far more than the two cubes farthest apart.
  const std::vector<CellBox> boxes = {cube(-60, 0, 0),
                                      {.min = {-50, 0, 0}, .max = {50, 1, 1}},
                                      {.min = {0, -50, 0}, .max = {1, 50, 1}},
                                      cube(60, 0, 0),
                                      cube(61, 0, 0)};
  const auto second = parts(boxes, 1, Split::quadratic);
  EXPECT_NE(second[1], second[2]);
  EXPECT_EQ(second[0], second[1]);
  EXPECT_EQ(second[3], second[1]);
}

TEST(Split, LinearSeedsAreThePairFarthestApartInWidthsOfTheAxis) {
  // 90 of 100 cells apart on y beats 800 of 1000 on x.
  const std::vector<CellBox> boxes = {{.min = {0, 40, 0}, .max = {100, 60, 1}},
                                      {.min = {900, 40, 0}, .max = {1000, 60, 1}},
                                      {.min = {400, 0, 0}, .max = {500, 5, 1}},
                                      {.min = {400, 95, 0}, .max = {500, 100, 1}}};
  const auto second = parts(boxes, 1, Split::linear);
  EXPECT_FALSE(second[2]);
  EXPECT_TRUE(second[3]);
}

TEST(Split, EqualsGuttmansTextOnAllData) {
  int compared = 0;
  for (const Data data : test::kAllData) {
    for (const int edge : {0, 1, 8}) {
      for (const Split split : {Split::quadratic, Split::linear}) {
        Random random(static_cast<std::uint64_t>(data) * 100 + static_cast<std::uint64_t>(edge));
        SCOPED_TRACE(random.trace());
        for (const int count : {2, 5, 6, 9, 17, 34, 65}) {
          const auto boxes = test::boxes_of(data, edge, static_cast<std::size_t>(count), random);
          for (const int min_branches : {1, (count - 1) / 2}) {
            if (min_branches < 1) continue;
            const auto second = parts(boxes, min_branches, split);
            ASSERT_EQ(second, test::plain_partition(boxes, min_branches, split));
            const auto in_second = std::count(second.begin(), second.end(), true);
            ASSERT_GE(in_second, min_branches);
            ASSERT_GE(count - in_second, min_branches);
            ++compared;
          }
        }
      }
    }
  }
  EXPECT_EQ(compared, 9 * 3 * 2 * (7 * 2 - 1));
}

}  // namespace
}  // namespace rmap
