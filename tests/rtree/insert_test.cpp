#include "rtree/boxes.hpp"
#include "rtree/plain_tree.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/rtree/box_tree.hpp>

namespace rmap {
namespace {

using test::Data;
using test::Random;

constexpr std::size_t kInserted = 130;

const std::byte* bytes_of(const int& payload) {
  return reinterpret_cast<const std::byte*>(&payload);
}

TEST(Insert, BuildsTheVeryTreeOfThePlainAlgorithm) {
  int compared = 0;
  for (const RTreeOptions& options : test::all_options()) {
    for (const Data data : test::kAllData) {
      Random random(static_cast<std::uint64_t>(data));
      SCOPED_TRACE(random.trace() + ", " + test::text_of(options));
      BoxTree tree(options, sizeof(int), alignof(int));
      test::PlainTree plain(tree.options());
      int payload = 0;
      for (const CellBox& box : test::boxes_of(data, options.leaf_edge, kInserted, random)) {
        tree.insert(box, bytes_of(payload));
        plain.insert(box, payload++);
        ASSERT_EQ(tree.check(), std::nullopt);
        if (payload % 10 == 0) {
          ASSERT_TRUE(plain.same_as(tree)) << payload;
        }
      }
      ASSERT_EQ(tree.size(), kInserted);
      ++compared;
    }
  }
  EXPECT_EQ(compared, 72 * 9);
}

/// A row of cells along x.
CellBox row(int from, int to) { return {.min = {from, 0, 0}, .max = {to, 1, 1}}; }

/// Packs seven rows into leaves of 4 and 3, erases `erased` of the first, inserts a row that lies
/// in both leaves, and says in which one it ended.
int chosen_leaf(const std::vector<CellBox>& rows, int erased) {
  BoxTree tree({.max_branches = 4, .min_branches = 1}, sizeof(int), alignof(int));
  const int payload = 1;
  tree.load(
      rows, [&](std::size_t) { return bytes_of(payload); }, Packing::sort_tile_recursive);
  for (int i = 0; i < erased; ++i) {
    EXPECT_TRUE(tree.erase(rows[static_cast<std::size_t>(i)], [](BoxTree::Place) { return true; }));
  }
  const auto branches = [&](int leaf) {
    return tree.nodes(0).count(tree.nodes(1).child(tree.root(), leaf));
  };
  EXPECT_EQ(branches(0), 4 - erased);
  EXPECT_EQ(branches(1), 3);
  tree.insert(row(9, 10), bytes_of(payload));
  EXPECT_EQ(branches(0) + branches(1), 8 - erased);
  return branches(1) == 4 ? 1 : 0;
}

TEST(Insert, TiesGoToTheSmallerVolumeThenToFewerBranches) {
  // The MBRCs are [0, 12) and [8, 14).
  const std::vector<CellBox> unlike = {row(1, 2), row(2, 3),   row(0, 1),  row(0, 12),
                                       row(8, 9), row(10, 11), row(13, 14)};
  EXPECT_EQ(chosen_leaf(unlike, 2), 1);
  EXPECT_EQ(chosen_leaf(unlike, 0), 1);
  // The MBRCs are [0, 12) and [6, 18).
  const std::vector<CellBox> alike = {row(1, 2),  row(2, 3),   row(0, 1),  row(0, 12),
                                      row(6, 18), row(13, 14), row(14, 15)};
  EXPECT_EQ(chosen_leaf(alike, 2), 0);
  EXPECT_EQ(chosen_leaf(alike, 1), 0);  // even: the first
  EXPECT_EQ(chosen_leaf(alike, 0), 1);
}

TEST(Insert, RefusesWhatItCannotHoldAndStaysAsItWas) {
  BoxTree boxes({}, sizeof(int), alignof(int));
  BoxTree cubes({.leaf_edge = 8}, sizeof(int), alignof(int));
  const int payload = 1;
  const auto refusal = [&](BoxTree& tree, const CellBox& box, ErrorKind kind) -> std::string {
    try {
      tree.insert(box, bytes_of(payload));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind);
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(refusal(boxes, {.min = {1, 2, 3}, .max = {4, 2, 9}}, ErrorKind::input),
            "the box from (1, 2, 3) to (4, 2, 9) is empty: an R-tree holds boxes with a volume");
  EXPECT_EQ(refusal(boxes, {.min = {0, 0, 0}, .max = {1, 1, (1 << 30) + 1}}, ErrorKind::limit),
            "the box from (0, 0, 0) to (1, 1, 1073741825) leaves the limits: cell indices lie in "
            "-1073741824 to 1073741823");
  EXPECT_EQ(refusal(cubes, {.min = {0, 0, 0}, .max = {8, 8, 7}}, ErrorKind::input),
            "the box from (0, 0, 0) to (8, 8, 7) is no cube of 8 x 8 x 8 cells, which this "
            "R-tree's leaf_edge asks for");
  EXPECT_EQ(boxes.size(), 0u);
  EXPECT_EQ(boxes.height(), 0);
  EXPECT_EQ(boxes.check(), std::nullopt);
}

}  // namespace
}  // namespace rmap
