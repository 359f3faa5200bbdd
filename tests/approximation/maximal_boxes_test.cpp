#include "approximation/maximal_boxes.hpp"

#include "approximation/plain_cells.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::CellSet;
using test::Random;

struct Scene {
  BitGrid grid;
  CellSet plain;
};

// A set in a grid with the room around that it must have.
Scene random_scene(const Cell& edges, double density, Random& random) {
  Scene scene{BitGrid(edges + Cell::Constant(2)), {}};
  test::for_each_cell_in({.min = Cell::Ones(), .max = edges + Cell::Ones()}, [&](const Cell& cell) {
    if (!random.chance(density)) return;
    scene.grid.set(cell);
    scene.plain.insert(cell);
  });
  return scene;
}

/// Axes on which a box can grow by one cell, either way.
int axes_of_growth(const CellSet& cells, const CellBox& box) {
  int axes = 0;
  for (int axis = 0; axis < 3; ++axis) {
    CellBox above = box;
    above.min[axis] = box.max[axis];
    above.max[axis] = box.max[axis] + 1;
    CellBox below = box;
    below.max[axis] = box.min[axis];
    below.min[axis] = box.min[axis] - 1;
    axes += test::holds(cells, above) || test::holds(cells, below) ? 1 : 0;
  }
  return axes;
}

/// Every box inside the set that holds the core and cannot grow.
std::vector<CellBox> maximal_by_force(const CellSet& cells, const CellBox& core, const Cell& size) {
  std::vector<CellBox> boxes;
  test::for_each_cell_in(
      {.min = Cell::Ones(), .max = core.min + Cell::Ones()}, [&](const Cell& min) {
        test::for_each_cell_in({.min = core.max, .max = size}, [&](const Cell& max) {
          const CellBox box{.min = min, .max = max};
          if (test::holds(cells, box) && axes_of_growth(cells, box) == 0) boxes.push_back(box);
        });
      });
  return boxes;
}

// Grids of up to six cells each way: every window is looked at, so that no maximal box is missed.
TEST(MaximalBoxes, AllOfSmallSetsAreVisited) {
  int visited = 0;
  int expected = 0;
  for (int round = 0; round < 4000; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(random.trace());
    const Cell edges = random.cell(2, 6);
    const Scene scene = random_scene(edges, random.real(0.5, 1), random);
    if (scene.plain.empty()) continue;
    MaximalBoxes maximal(scene.grid);
    for (int asked = 0; asked < 4; ++asked) {
      CellBox core = box_of(random.cell(0, 5).cwiseMin(edges - Cell::Ones()) + Cell::Ones());
      if (random.chance(0.4)) core.max += random.cell(0, 1);
      if (!test::holds(scene.plain, core)) continue;
      std::vector<CellBox> boxes;
      maximal.for_each(core, [&](const CellBox& box) { boxes.push_back(box); });
      for (const CellBox& box : boxes) {
        ASSERT_TRUE(box.contains(core));
        ASSERT_TRUE(test::holds(scene.plain, box));
        ASSERT_LE(axes_of_growth(scene.plain, box), 1);
        ++visited;
      }
      for (const CellBox& box : maximal_by_force(scene.plain, core, scene.grid.size())) {
        ASSERT_TRUE(std::find(boxes.begin(), boxes.end(), box) != boxes.end())
            << box.min.transpose() << " to " << box.max.transpose() << " around "
            << core.min.transpose() << " to " << core.max.transpose();
        ++expected;
      }
    }
  }
  EXPECT_GT(visited, 10000);
  EXPECT_GT(expected, 10000);
}

TEST(MaximalBoxes, VisitedOnesAreSoundWhereThereAreManyWindows) {
  int visited = 0;
  for (int round = 0; round < 6; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(random.trace());
    const Scene scene = random_scene({70, 20, 24}, random.real(0.95, 1), random);
    MaximalBoxes maximal(scene.grid);
    for (int asked = 0; asked < 3; ++asked) {
      const CellBox core = box_of(random.cell(1, 20));
      if (!test::holds(scene.plain, core)) continue;
      maximal.for_each(core, [&](const CellBox& box) {
        ASSERT_TRUE(box.contains(core));
        ASSERT_TRUE(scene.grid.holds(box));
        if (++visited % 10 == 0) {
          ASSERT_LE(axes_of_growth(scene.plain, box), 1);
        }
      });
    }
  }
  EXPECT_GT(visited, 100);
}

TEST(MaximalBoxes, ASolidBoxIsTheOnlyOne) {
  Random random(1);
  const Scene scene = random_scene({68, 9, 30}, 1, random);
  MaximalBoxes maximal(scene.grid);
  const CellBox whole{.min = Cell::Ones(), .max = {69, 10, 31}};
  std::vector<CellBox> boxes;
  maximal.for_each(box_of({40, 5, 17}), [&](const CellBox& box) { boxes.push_back(box); });
  EXPECT_EQ(boxes, std::vector{whole});
  EXPECT_EQ(maximal.grown(box_of({40, 5, 17})), whole);
}

TEST(MaximalBoxes, GrownOnesGrowNoFurther) {
  int grown = 0;
  for (int round = 0; round < 300; ++round) {
    Random random(static_cast<std::uint64_t>(round));
    SCOPED_TRACE(random.trace());
    const Scene scene = random_scene(random.cell(3, 9), random.real(0.7, 1), random);
    const CellBox core = box_of(random.cell(1, 4));
    if (!test::holds(scene.plain, core)) continue;
    const CellBox box = MaximalBoxes(scene.grid).grown(core);
    ASSERT_TRUE(box.contains(core));
    ASSERT_TRUE(test::holds(scene.plain, box));
    ASSERT_EQ(axes_of_growth(scene.plain, box), 0);
    ++grown;
  }
  EXPECT_GT(grown, 150);
}

}  // namespace
}  // namespace rmap
