#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/lattice.hpp>

namespace rmap {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

template <class Call>
std::string refusal(Call&& call, ErrorKind kind) {
  try {
    call();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind);
    return error.what();
  }
  return "accepted";
}

TEST(Lattice, RefusesResolutionsThatAreNone) {
  for (const double resolution : {0.0, -0.1, std::nan(""), kInfinity, 1e-7, 1e7, 5e-324}) {
    EXPECT_THAT(refusal([&] { Lattice lattice(resolution); }, ErrorKind::input),
                testing::StartsWith("resolution is "));
  }
  EXPECT_EQ(Lattice(1e-6).resolution(), 1e-6);
  EXPECT_EQ(Lattice(1e6).resolution(), 1e6);
}

TEST(Lattice, CellsAreHalfOpen) {
  const Lattice lattice(0.5);
  EXPECT_EQ(lattice.cell_of({0, 0.49999, 0.5}), Cell(0, 0, 1));
  EXPECT_EQ(lattice.cell_of({-1e-300, -0.5, -0.50001}), Cell(-1, -1, -2));
}

TEST(Lattice, NamesPointsThatDoNotFit) {
  const Lattice lattice(1);
  const double limit = 0x1p30;
  EXPECT_EQ(lattice.cell_of({limit - 1, -limit, limit - 1e-6}),
            Cell(kMaxCellIndex, kMinCellIndex, kMaxCellIndex));
  for (const double bad : {limit, -limit - 1e-6, kInfinity, -kInfinity, std::nan("")}) {
    for (int axis = 0; axis < 3; ++axis) {
      Vector3d point(1, 2, 3);
      point[axis] = bad;
      EXPECT_FALSE(lattice.find_cell(point));
      EXPECT_THAT(refusal([&] { static_cast<void>(lattice.cell_of(point)); }, ErrorKind::limit),
                  testing::AllOf(testing::HasSubstr("the point ("),
                                 testing::HasSubstr(std::isfinite(bad) ? "+-1073741823 m"
                                                                       : "m is not finite")));
    }
  }
  // As people write it, not 107374182.30000001.
  EXPECT_THAT(refusal(
                  [] {
                    static_cast<void>(Lattice(0.1).cell_of({1e9, 0, 0}));
                  },
                  ErrorKind::limit),
              testing::EndsWith("+-107374182.3 m"));
}

TEST(LatticeBox, DecimalBordersMeanWhatPeopleMean) {
  const Lattice lattice(0.1);
  // Each of these borders misses its cell border by a rounding error in one direction or other.
  for (int low = -300; low < 300; ++low) {
    for (const int edge : {1, 3, 7}) {
      const double a = low / 10.0;
      const double b = (low + edge) / 10.0;
      const CellBox cells = lattice.cells_of({.min = {a, a, a}, .max = {b, b, b}});
      ASSERT_EQ(cells.min, Cell::Constant(low)) << a;
      ASSERT_EQ(cells.max, Cell::Constant(low + edge)) << b;
    }
  }
}

TEST(LatticeBox, MeansTheCellsThatItOverlaps) {
  const Lattice lattice(0.1);
  const CellBox cells =
      lattice.cells_of({.min = {0.05, -0.31, 0.3}, .max = {0.06, -0.3, 0.600001}});
  EXPECT_EQ(cells.min, Cell(0, -4, 3));
  EXPECT_EQ(cells.max, Cell(1, -3, 7));
  // 1e-6 of a cell still snaps, more does not.
  EXPECT_EQ(lattice.cells_of({.min = {0, 0, 0}, .max = {0.10000009, 0.1, 0.1}}).max.x(), 1);
  EXPECT_EQ(lattice.cells_of({.min = {0, 0, 0}, .max = {0.1000002, 0.1, 0.1}}).max.x(), 2);
}

TEST(LatticeBox, InfiniteBordersMeanTheLimits) {
  const Vector3d all = Vector3d::Constant(kInfinity);
  EXPECT_EQ(Lattice(0.1).cells_of({.min = -all, .max = all}), all_cells());
  const CellBox half = Lattice(0.1).cells_of({.min = {0, -kInfinity, 0}, .max = {1, 0, kInfinity}});
  EXPECT_EQ(half.min, Cell(0, kMinCellIndex, 0));
  EXPECT_EQ(half.max, Cell(10, 0, kMaxCellIndex + 1));
}

TEST(LatticeBox, RefusesBoxesThatMeanNothing) {
  const Lattice lattice(0.1);
  const auto refused = [&](const Box& box, ErrorKind kind) {
    return refusal([&] { static_cast<void>(lattice.cells_of(box)); }, kind);
  };
  EXPECT_EQ(refused({.min = {0, 1, 0}, .max = {1, 1, 1}}, ErrorKind::input),
            "the box is empty: y runs from 1 to 1 m");
  EXPECT_EQ(refused({.min = {0, 0, 2}, .max = {1, 1, 1}}, ErrorKind::input),
            "the box is empty: z runs from 2 to 1 m");
  // Thinner than the snap, and on a border: nothing is left of it.
  EXPECT_THAT(refused({.min = {0.3, 0, 0}, .max = {0.30000001, 1, 1}}, ErrorKind::input),
              testing::StartsWith("the box is empty: x"));
  EXPECT_THAT(refused({.min = {std::nan(""), 0, 0}, .max = {1, 1, 1}}, ErrorKind::input),
              testing::HasSubstr("not a number"));
  EXPECT_THAT(refused({.min = {kInfinity, 0, 0}, .max = {kInfinity, 1, 1}}, ErrorKind::input),
              testing::StartsWith("the box is empty"));
  EXPECT_THAT(refused({.min = {0, 0, 0}, .max = {1, 1e12, 1}}, ErrorKind::limit),
              testing::HasSubstr("in y: at a resolution of 0.1 m it must lie within"));
}

}  // namespace
}  // namespace rmap
