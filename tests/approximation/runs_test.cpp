#include "approximation/runs.hpp"

#include "approximation/plain_cells.hpp"
#include "support/cell_sets.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

TEST(Runs, AreDisjointAndExact) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    for (const auto& [name, cells] : test::small_scenes(random)) {
      SCOPED_TRACE(name);
      const auto boxes = run_boxes(sorted_cells(test::counted(cells)));
      ASSERT_EQ(test::union_of(boxes), test::set_of(cells));
      ASSERT_EQ(test::overlap(boxes), "");
      ++compared;
    }
  }
  EXPECT_EQ(compared, 10 * 15);
}

/// Whether two boxes are one cut in two across z.
bool continued(const CellBox& a, const CellBox& b) {
  CellBox joined = a;
  joined.max.z() = b.max.z();
  return a.max.z() == b.min.z() && united(a, b) == joined &&
         joined.volume() == a.volume() + b.volume();
}

TEST(Runs, LeaveNoTwoBoxesThatContinueOneAnother) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed, ++compared) {
    Random random(seed);
    SCOPED_TRACE(random.trace());
    const auto cells = test::random_fill(random, 8, random.real(0.5, 0.95));
    const auto boxes = run_boxes(sorted_cells(test::counted(cells)));
    for (const CellBox& a : boxes) {
      for (const CellBox& b : boxes) ASSERT_FALSE(continued(a, b));
    }
  }
  EXPECT_EQ(compared, 20);
}

TEST(Runs, JoinWhatIsEqual) {
  const CellBox box{.min = {-3, 4, -5}, .max = {9, 8, 7}};
  EXPECT_EQ(run_boxes(sorted_cells(test::counted(test::solid_box(box)))), std::vector{box});
  EXPECT_EQ(run_boxes(sorted_cells(test::counted(test::hollow_box(box)))).size(), 6u);
  EXPECT_TRUE(run_boxes({}).empty());
}

}  // namespace
}  // namespace rmap
