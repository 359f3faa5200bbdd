#include "support/nasty_beams.hpp"
#include "support/plain_crossing.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include <rmap/beam.hpp>

namespace rmap {
namespace {

using test::BeamEnds;
using test::BeamKind;
using test::PlainBeam;
using test::Random;

PlainBeam plain(const Beam& beam) {
  PlainBeam copy{.origin = {}, .end = {}, .cut = beam.cut()};
  for (int axis = 0; axis < 3; ++axis) {
    copy.origin[static_cast<std::size_t>(axis)] = beam.origin()[axis];
    copy.end[static_cast<std::size_t>(axis)] = beam.end()[axis];
  }
  return copy;
}

std::vector<Cell> walked(const Beam& beam, const CellBox& within) {
  std::vector<Cell> cells;
  for (BeamWalk walk(beam, within); walk.more(); walk.advance()) cells.push_back(walk.cell());
  return cells;
}

std::vector<Cell> sorted(std::vector<Cell> cells) {
  std::sort(cells.begin(), cells.end(), morton_less);
  return cells;
}

CellBox around(const Vector3d& center, int reach) {
  const Cell middle = center.array().floor().cast<std::int32_t>();
  return {.min = middle.array() - reach, .max = middle.array() + reach + 1};
}

// Crossing, walk and oracle must agree on every cell of a box that holds the beam.
void expect_agreement(const Beam& beam, const CellBox& box) {
  const auto expected = sorted(test::plain_crossed_cells(plain(beam), box));
  const auto walk = walked(beam, box);
  EXPECT_EQ(sorted(walk), expected);
  for (const Cell& cell : walk) EXPECT_TRUE(crosses(beam, cell));
  for (const Cell& cell : expected) EXPECT_TRUE(crosses(beam, cell));
}

class NastyBeams : public testing::TestWithParam<int> {};

TEST_P(NastyBeams, WalkAndCrossingEqualTheDefinition) {
  const auto kind = static_cast<BeamKind>(GetParam());
  Random random(100 + static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(random.trace());
  int cases = 0;
  std::size_t crossed = 0;
  for (int i = 0; i < 300 && !HasFailure(); ++i) {
    const BeamEnds ends = nasty_beam(kind, random, 6);
    const Beam beam(ends.origin, ends.end, random.chance(0.5));
    SCOPED_TRACE(testing::Message()
                 << "from " << ends.origin.transpose() << " to " << ends.end.transpose());
    expect_agreement(beam, around(Vector3d::Zero(), 14));
    crossed += walked(beam, around(Vector3d::Zero(), 14)).size();
    ++cases;
  }
  EXPECT_EQ(cases, 300);
  EXPECT_GT(crossed, 100u);
}

TEST_P(NastyBeams, WalkInsideABoxMeetsThatPartOfTheBeam) {
  const auto kind = static_cast<BeamKind>(GetParam());
  Random random(200 + static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(random.trace());
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const BeamEnds ends = nasty_beam(kind, random, 20);
    const Beam beam(ends.origin, ends.end, true);
    const CellBox box = random.box(-25, 10, 30);
    const auto inside = walked(beam, box);
    std::vector<Cell> expected;
    for (const Cell& cell : walked(beam, around(Vector3d::Zero(), 90))) {
      if (box.contains(cell)) expected.push_back(cell);
    }
    ASSERT_EQ(inside, expected) << "from " << ends.origin.transpose() << " to "
                                << ends.end.transpose();
    ASSERT_EQ(crossing(beam, box).has_value() || inside.empty(), true);
    met += inside.empty() ? 0 : 1;
  }
  EXPECT_GT(met, 50);
}

// Cubes of cells are crossed by the rule of boxes: with their outer planes.
TEST_P(NastyBeams, WalkThroughCubesMeetsThoseThatAreCrossed) {
  const auto kind = static_cast<BeamKind>(GetParam());
  Random random(250 + static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(random.trace());
  std::size_t met = 0;
  for (int i = 0; i < 400; ++i) {
    const std::int32_t edge = 1 << random.integer(1, 3);
    // Limits far out, too, where a double has few bits left for the place within a cell.
    const double far = i % 4 == 0 ? 0x1p30 - 64 : i % 4 == 1 ? -0x1p30 + 64 : 0;
    const BeamEnds ends = nasty_beam(kind, random, 3 * edge, Vector3d::Constant(far));
    const Beam beam(ends.origin, ends.end, random.chance(0.5));
    const Cell middle = Cell::Constant(static_cast<std::int32_t>(far));
    const CellBox within = {
        .min = middle + edge * random.cell(-5, 0),
        .max = middle + edge * random.cell(1, 5),
    };
    std::vector<Cell> expected;
    for (std::int32_t x = within.min.x(); x < within.max.x(); x += edge) {
      for (std::int32_t y = within.min.y(); y < within.max.y(); y += edge) {
        for (std::int32_t z = within.min.z(); z < within.max.z(); z += edge) {
          const Cell low(x, y, z);
          if (crossing(beam, {.min = low, .max = low + Cell::Constant(edge)})) {
            expected.push_back(low);
          }
        }
      }
    }
    std::vector<Cell> cubes;
    double before = -1;
    for (BeamWalk walk(beam, within, edge); walk.more(); walk.advance()) {
      const Cell low = walk.cell();
      const CellBox cube = {.min = low, .max = low + Cell::Constant(edge)};
      ASSERT_EQ(walk.enter(), crossing(beam, cube)->enter);
      ASSERT_LT(before, walk.enter());
      before = walk.enter();
      cubes.push_back(low);
    }
    ASSERT_EQ(sorted(cubes), sorted(expected))
        << "from " << ends.origin.transpose() << " to " << ends.end.transpose();
    met += cubes.size();
  }
  EXPECT_GT(met, 50U);
}

// Far from zero a double has few bits left for the place within a cell.
TEST_P(NastyBeams, AgreesNearTheLimitsOfIndices) {
  const auto kind = static_cast<BeamKind>(GetParam());
  Random random(300 + static_cast<std::uint64_t>(GetParam()));
  SCOPED_TRACE(random.trace());
  int cases = 0;
  for (int i = 0; i < 60 && !HasFailure(); ++i) {
    Vector3d center;
    for (double& component : center) component = random.chance(0.5) ? 0x1p30 - 20 : -0x1p30 + 20;
    const BeamEnds ends = nasty_beam(kind, random, 5, center);
    expect_agreement(Beam(ends.origin, ends.end, random.chance(0.5)), around(center, 12));
    ++cases;
  }
  EXPECT_EQ(cases, 60);
}

INSTANTIATE_TEST_SUITE_P(Kinds, NastyBeams, testing::Range(0, test::kBeamKinds),
                         [](const auto& kind_info) {
                           return test::name_of(static_cast<BeamKind>(kind_info.param));
                         });

TEST(Beam, TouchingFromOutsideCrossesNothing) {
  // Ends in the face x = 3 from below: cell 3 holds the end but is not crossed.
  EXPECT_EQ(walked(Beam({0.5, 0.5, 0.5}, {3, 0.5, 0.5}, true), around({0, 0, 0}, 9)),
            (std::vector<Cell>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}));
  // Starts in the face x = 3 and goes down: cell 3 holds the origin but is not crossed.
  EXPECT_EQ(walked(Beam({3, 0.5, 0.5}, {1.5, 0.5, 0.5}, true), around({0, 0, 0}, 9)),
            (std::vector<Cell>{{2, 0, 0}, {1, 0, 0}}));
  // Passes the corner (1, 1, *) of four columns: only the two on the diagonal are crossed.
  EXPECT_EQ(walked(Beam({0.5, 0.5, 0.5}, {1.5, 1.5, 0.5}, true), around({0, 0, 0}, 9)),
            (std::vector<Cell>{{0, 0, 0}, {1, 1, 0}}));
  EXPECT_FALSE(crosses(Beam({0.5, 0.5, 0.5}, {1.5, 1.5, 0.5}, true), {1, 0, 0}));
}

TEST(Beam, InAFaceBelongsToTheUpperCell) {
  EXPECT_EQ(walked(Beam({0.5, 2, 0.5}, {2.5, 2, 0.5}, true), around({0, 0, 0}, 9)),
            (std::vector<Cell>{{0, 2, 0}, {1, 2, 0}, {2, 2, 0}}));
  EXPECT_EQ(walked(Beam({0.5, 2, -1}, {2.5, 2, -1}, true), around({0, 0, 0}, 9)),
            (std::vector<Cell>{{0, 2, -1}, {1, 2, -1}, {2, 2, -1}}));
}

TEST(Beam, OfLengthZeroCrossesItsCellOnlyWhenCut) {
  const Vector3d place(1.25, -0.5, 3);
  EXPECT_EQ(walked(Beam(place, place, true), around({0, 0, 0}, 9)),
            (std::vector<Cell>{{1, -1, 3}}));
  EXPECT_TRUE(walked(Beam(place, place, false), around({0, 0, 0}, 9)).empty());
  EXPECT_FALSE(crosses(Beam(place, place, false), {1, -1, 3}));
}

// With a reciprocal instead of the division, such beams cross the cell behind their end.
TEST(Beam, EndingOnAPlaneStaysBeforeIt) {
  Random random(7);
  SCOPED_TRACE(random.trace());
  for (int i = 0; i < 100000; ++i) {
    const int length = random.integer(1, 400);
    const double start = random.real(-200, 200);
    const double end = std::floor(start) + length;
    const Beam beam({start, 0.5, 0.5}, {end, 0.5, 0.5}, false);
    ASSERT_FALSE(crosses(beam, Cell(static_cast<int>(end), 0, 0))) << start << " to " << end;
    ASSERT_TRUE(crosses(beam, Cell(static_cast<int>(end) - 1, 0, 0)));
  }
}

// A box is crossed whenever one of its cells is: what lets a tree of boxes be searched.
TEST(Crossing, OfABoxHoldsTheCrossingsOfItsCells) {
  Random random(8);
  SCOPED_TRACE(random.trace());
  std::size_t cells = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto kind = static_cast<BeamKind>(random.integer(0, test::kBeamKinds - 1));
    const BeamEnds ends = nasty_beam(kind, random, 20);
    const Beam beam(ends.origin, ends.end, true);
    const CellBox box = random.box(-15, 5, 12);
    const auto whole = crossing(beam, box);
    for (const Cell& cell : walked(beam, box)) {
      const auto part = crossing(beam, box_of(cell));
      ASSERT_TRUE(whole && part);
      ASSERT_LE(whole->enter, part->enter);
      ASSERT_GE(whole->leave, part->leave);
      ++cells;
    }
  }
  EXPECT_GT(cells, 3000u);
}

}  // namespace
}  // namespace rmap
