#include "support/grids.hpp"
#include "support/nasty_beams.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/cast_ray.hpp>
#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::BeamKind;
using test::Random;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The plain twin: asks the cell of the origin, then walks from cell to cell and asks each one.
std::optional<Cell> walked_hit(const Grid& grid, const Vector3d& origin, const Vector3d& along,
                               double range) {
  const Lattice& lattice = grid.lattice();
  // The end as cast_ray computes it: scaled, normalised, and as long as the range.
  const Vector3d scaled = along / along.cwiseAbs().maxCoeff();
  const Vector3d end = origin + scaled / scaled.norm() * range;
  if (grid.state(origin) == State::occupied) return lattice.cell_of(origin);
  const Beam beam(lattice.to_cells(origin), lattice.to_cells(end), true);
  for (BeamWalk walk(beam, all_cells()); walk.more(); walk.advance()) {
    if (grid.cell_state(walk.cell()) == State::occupied) return walk.cell();
  }
  return std::nullopt;
}

// Whether the range ends a ray before the map's bounds do: then it is the twin's beam.
bool ends_in_bounds(const Grid& grid, const Vector3d& origin, double range) {
  const Box bounds = grid.lattice().metric(grid.block_bounds());
  return (bounds.min - origin).cwiseAbs().cwiseMax((bounds.max - origin).cwiseAbs()).norm() >=
         range;
}

class CastRayInLayout : public testing::TestWithParam<Layout> {};
INSTANTIATE_TEST_SUITE_P(Layouts, CastRayInLayout, testing::Values(Layout::blocks, Layout::cells));

TEST_P(CastRayInLayout, FindsTheFirstOccupiedCellOfTheWalk) {
  Random random(36);
  SCOPED_TRACE(random.trace());
  int hits = 0;
  int misses = 0;
  for (int round = 0; round < 10; ++round) {
    const Grid grid = test::clustered_grid(
        random, {.resolution = 0.5, .layout = GetParam(), .max_branches = 4}, 12);
    for (int i = 0; i < 300; ++i) {
      const auto kind = static_cast<BeamKind>(random.integer(0, test::kBeamKinds - 1));
      const test::BeamEnds ends = nasty_beam(kind, random, 16);
      const Vector3d origin = ends.origin * 0.5;
      const Vector3d along = (ends.end - ends.origin) * 0.5;
      if (along.norm() == 0) continue;
      const double range = along.norm();
      if (!ends_in_bounds(grid, origin, range)) continue;
      const auto expected = walked_hit(grid, origin, along, range);
      const auto hit = cast_ray(grid, origin, along, range);
      ASSERT_EQ(hit.has_value(), expected.has_value())
          << origin.transpose() << " along " << along.transpose();
      if (hit) {
        ASSERT_EQ(hit->cell, *expected);
        ASSERT_LE(hit->distance, range);
        // The point of entry lies on the cell, on the face that is named.
        const Box box = grid.lattice().metric(box_of(hit->cell));
        const Vector3d outside = (box.min - hit->point).cwiseMax(hit->point - box.max).cwiseMax(0);
        ASSERT_LT(outside.norm(), 1e-9);
        if (hit->face == Face::none) {
          ASSERT_EQ(hit->distance, 0);
        } else {
          const int axis = (static_cast<int>(hit->face) - 1) / 2;
          const bool upper = (static_cast<int>(hit->face) - 1) % 2 == 1;
          ASSERT_NEAR(hit->point[axis], upper ? box.max[axis] : box.min[axis], 1e-9);
          ASSERT_EQ(upper, along[axis] < 0);
        }
      }
      hits += hit ? 1 : 0;
      misses += hit ? 0 : 1;
    }
  }
  EXPECT_GT(hits, 100);
  EXPECT_GT(misses, 100);
}

TEST_P(CastRayInLayout, NamesPlaceFaceAndDistance) {
  Grid grid({.resolution = 0.5, .layout = GetParam()});
  grid.set({10, 0, 0}, 0.9);  // x from 5 to 5.5 m
  const auto hit = cast_ray(grid, {1.25, 0.25, 0.25}, {2, 0, 0}, kInfinity);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->cell, Cell(10, 0, 0));
  EXPECT_NEAR(hit->distance, 3.75, 1e-12);
  EXPECT_NEAR(hit->point.x(), 5, 1e-12);
  EXPECT_EQ(hit->face, Face::min_x);
  const auto back = cast_ray(grid, {9, 0.25, 0.25}, {-1, 0, 0}, kInfinity);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->face, Face::max_x);
  EXPECT_NEAR(back->distance, 3.5, 1e-12);
  const auto above = cast_ray(grid, {5.25, 0.25, 3}, {0, 0, -1}, kInfinity);
  ASSERT_TRUE(above);
  EXPECT_EQ(above->face, Face::max_z);

  const auto inside = cast_ray(grid, {5.25, 0.25, 0.25}, {0, 1, 0}, kInfinity);
  ASSERT_TRUE(inside);
  EXPECT_EQ(inside->face, Face::none);
  EXPECT_EQ(inside->distance, 0);
  EXPECT_EQ(inside->point, Vector3d(5.25, 0.25, 0.25));
}

// The cell of a point is that of its floor, whichever way a ray leaves it.
TEST_P(CastRayInLayout, StartsInTheCellOfItsOrigin) {
  Grid grid({.resolution = 0.5, .layout = GetParam()});
  grid.set({10, 0, 0}, 0.9);
  const Vector3d corner(5, 0, 0);
  int rays = 0;
  for (const double x : {-1.0, 0.0, 1.0}) {
    for (const double y : {-1.0, 0.0, 1.0}) {
      for (const double z : {-1.0, 0.0, 1.0}) {
        const Vector3d direction(x, y, z);
        if (direction.isZero(0)) continue;
        for (const double range : {0.0, 0.25, kInfinity}) {
          const auto hit = cast_ray(grid, corner, direction, range);
          ASSERT_TRUE(hit) << direction.transpose();
          EXPECT_EQ(hit->cell, Cell(10, 0, 0));
          EXPECT_EQ(hit->distance, 0);
          EXPECT_EQ(hit->face, Face::none);
          EXPECT_EQ(hit->point, corner);
          ++rays;
        }
      }
    }
  }
  EXPECT_EQ(rays, 78);
  // The upper face belongs to the next cell: from there the ray enters through it.
  const auto back = cast_ray(grid, {5.5, 0.25, 0.25}, {-1, 0, 0}, 1);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->distance, 0);
  EXPECT_EQ(back->face, Face::max_x);
}

// Rays through more blocks than are followed one by one.
TEST_P(CastRayInLayout, FindsWhatLiesFarAway) {
  Random random(85);
  SCOPED_TRACE(random.trace());
  int hits = 0;
  int misses = 0;
  for (int round = 0; round < 40; ++round) {
    Grid grid({.resolution = 1, .layout = GetParam()});
    // Targets, and what a search from block to block has on the way to them.
    std::vector<Vector3d> targets;
    for (int i = 0; i < 60; ++i) {
      const Vector3d target = random.direction() * random.real(10, 6000);
      grid.set(grid.lattice().cell_of(target), random.chance(0.5) ? 0.9 : 0.2);
      targets.push_back(target);
    }
    for (const Vector3d& target : targets) {
      const Vector3d origin = random.point(-3, 3);
      const Vector3d along = target - origin;
      const double range = along.norm() + 3;  // beyond the target
      if (!ends_in_bounds(grid, origin, range)) continue;
      const auto expected = walked_hit(grid, origin, along, range);
      const auto hit = cast_ray(grid, origin, along, range);
      ASSERT_EQ(hit.has_value(), expected.has_value()) << target.transpose();
      if (hit) {
        ASSERT_EQ(hit->cell, *expected);
      }
      hits += hit ? 1 : 0;
      misses += hit ? 0 : 1;
    }
  }
  EXPECT_GT(hits, 500);
  EXPECT_GT(misses, 500);
}

TEST(CastRay, IsTheSameInBothLayouts) {
  Random random(84);
  SCOPED_TRACE(random.trace());
  const Grid blocks = test::clustered_grid(random, {.resolution = 0.3}, 10);
  Grid cells({.resolution = 0.3, .layout = Layout::cells});
  cells.merge(blocks);
  int hits = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector3d origin = random.point(-5, 5);
    const Vector3d direction = random.direction();
    const auto one = cast_ray(blocks, origin, direction, kInfinity);
    const auto other = cast_ray(cells, origin, direction, kInfinity);
    ASSERT_EQ(one.has_value(), other.has_value());
    if (!one) continue;
    ++hits;
    ASSERT_EQ(one->cell, other->cell);
    ASSERT_EQ(one->distance, other->distance);
    ASSERT_EQ(one->point, other->point);
    ASSERT_EQ(one->face, other->face);
  }
  EXPECT_GT(hits, 100);
}

TEST_P(CastRayInLayout, IsCutAtItsRange) {
  Grid grid({.resolution = 0.5, .layout = GetParam()});
  grid.set({10, 0, 0}, 0.9);
  EXPECT_FALSE(cast_ray(grid, {0, 0.25, 0.25}, {1, 0, 0}, 5));  // touches the face
  EXPECT_TRUE(cast_ray(grid, {0, 0.25, 0.25}, {1, 0, 0}, 5.01));
  EXPECT_FALSE(cast_ray(grid, {0, 0.25, 0.25}, {1, 0, 0}, 0));
  EXPECT_FALSE(cast_ray(grid, {0, 0.25, 0.25}, {-1, 0, 0}, kInfinity));
  EXPECT_FALSE(cast_ray(grid, {0, 0.5, 0.25}, {1, 0, 0}, kInfinity));  // along the upper face
  EXPECT_TRUE(cast_ray(grid, {0, 0, 0.25}, {1, 0, 0}, kInfinity));     // along the lower face
  // Free cells do not stop a ray.
  grid.set({4, 0, 0}, 0.2);
  EXPECT_EQ(cast_ray(grid, {0, 0.25, 0.25}, {1, 0, 0}, kInfinity)->cell, Cell(10, 0, 0));
  EXPECT_FALSE(cast_ray(Grid({.resolution = 1}), {0, 0, 0}, {1, 0, 0}, kInfinity));
}

TEST_P(CastRayInLayout, TakesDirectionsOfAnyLength) {
  Grid grid({.resolution = 0.5, .layout = GetParam()});
  grid.set({10, 10, 10}, 0.9);
  for (const double length : {1e-320, 1e-200, 1.0, 1e300}) {
    const auto hit = cast_ray(grid, {0.1, 0.1, 0.1}, Vector3d(1, 1, 1) * length, kInfinity);
    ASSERT_TRUE(hit) << length;
    EXPECT_EQ(hit->cell, Cell(10, 10, 10));
  }
}

TEST_P(CastRayInLayout, RefusesWhatIsNoRay) {
  const Grid grid({.resolution = 0.5, .layout = GetParam()});
  EXPECT_THROW(cast_ray(grid, {0, 0, 0}, {0, 0, 0}, 1), Error);
  EXPECT_THROW(cast_ray(grid, {0, 0, 0}, {std::nan(""), 0, 0}, 1), Error);
  EXPECT_THROW(cast_ray(grid, {0, 0, 0}, {1, kInfinity, 0}, 1), Error);
  EXPECT_THROW(cast_ray(grid, {0, 0, 0}, {1, 0, 0}, -1), Error);
  EXPECT_THROW(cast_ray(grid, {0, 0, 0}, {1, 0, 0}, std::nan("")), Error);
  EXPECT_THROW(cast_ray(grid, {1e15, 0, 0}, {1, 0, 0}, 1), Error);
}

}  // namespace
}  // namespace rmap
