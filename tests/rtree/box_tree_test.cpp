#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/rtree/box_tree.hpp>

namespace rmap {
namespace {

std::string refusal(const RTreeOptions& options) {
  try {
    BoxTree tree(options, 4, 4);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    return error.what();
  }
  return "accepted";
}

TEST(BoxTree, RefusesOptionsThatMakeNoTree) {
  EXPECT_EQ(refusal({.max_branches = 3}), "the R-tree's max_branches is 3: it must lie in 4 to 64");
  EXPECT_EQ(refusal({.max_branches = 65}),
            "the R-tree's max_branches is 65: it must lie in 4 to 64");
  EXPECT_EQ(refusal({.max_branches = 5, .min_branches = 3}),
            "the R-tree's min_branches is 3: it must lie in 1 to 2");
  EXPECT_EQ(refusal({.min_branches = -1}),
            "the R-tree's min_branches is -1: it must lie in 1 to 8");
  EXPECT_EQ(refusal({.leaf_edge = -8}),
            "the R-tree's leaf_edge is -8: it must lie in 0 to 1073741824");
  EXPECT_EQ(refusal({.max_branches = 4, .min_branches = 2}), "accepted");
  EXPECT_EQ(refusal({.max_branches = 64, .min_branches = 1, .leaf_edge = 1 << 30}), "accepted");
}

TEST(BoxTree, ResolvesTheSmallestNumberOfBranches) {
  EXPECT_EQ(BoxTree({.max_branches = 33}, 4, 4).options().min_branches, 16);
  EXPECT_EQ(BoxTree({.max_branches = 33, .min_branches = 2}, 4, 4).options().min_branches, 2);
}

TEST(BoxTree, TheLargestCubesFit) {
  BoxTree tree({.leaf_edge = 1 << 30}, 4, 4);
  const int payload = 1;
  for (int i = 0; i < 8; ++i) {
    const Cell min = Cell(i & 1, i >> 1 & 1, i >> 2) * (1 << 30) - Cell::Constant(1 << 30);
    tree.insert({.min = min, .max = min + Cell::Constant(1 << 30)},
                reinterpret_cast<const std::byte*>(&payload));
  }
  EXPECT_EQ(tree.bounds(), all_cells());
  EXPECT_EQ(tree.check(), std::nullopt);
}

}  // namespace
}  // namespace rmap
