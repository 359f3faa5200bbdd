#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/rtree/box_tree.hpp>

namespace rmap {

namespace test {

/// Reaches into a tree to break it.
struct BoxTreeDamage {
  explicit BoxTreeDamage(BoxTree& broken) : tree(broken) {}

  NodePool& inner() const { return tree.inner_; }
  NodePool& leaves() const { return tree.leaves_; }
  std::uint32_t& root() const { return tree.root_; }
  int& height() const { return tree.height_; }
  std::size_t& size() const { return tree.size_; }

  std::uint32_t child(int branch) const { return inner().child(root(), branch); }
  void set_child(std::uint32_t node, int branch, std::uint32_t id) const {
    std::memcpy(inner().content(node, branch), &id, sizeof(id));
  }
  BoxTree& tree;
};

}  // namespace test

namespace {

using test::BoxTreeDamage;
using testing::HasSubstr;

/// Of height 3: 40 cells on a line, M 4, n 2, packed.
class Check : public testing::Test {
 protected:
  Check() {
    std::vector<CellBox> boxes;
    for (int i = 0; i < 40; ++i) boxes.push_back(box_of({i, 0, 0}));
    const int payload = 7;
    tree_.load(
        boxes, [&](std::size_t) { return reinterpret_cast<const std::byte*>(&payload); },
        Packing::sort_tile_recursive);
  }

  std::string failure() const { return tree_.check().value_or("sound"); }

  BoxTree tree_{{.max_branches = 4, .min_branches = 2}, sizeof(int), alignof(int)};
  BoxTreeDamage damage_{tree_};
};

TEST_F(Check, TheTreeIsSoundBeforehand) {
  EXPECT_EQ(failure(), "sound");
  EXPECT_EQ(tree_.height(), 3);
}

TEST_F(Check, FindsAWrongCountOfItems) {
  ++damage_.size();
  EXPECT_EQ(failure(), "the leaves hold 40 items, but the tree counts 41");
}

TEST_F(Check, FindsANodeWithTooFewBranches) {
  const auto leaf = damage_.inner().child(damage_.child(0), 0);
  damage_.leaves().truncate(leaf, 1);
  EXPECT_THAT(failure(), HasSubstr("of level 0 has 1 branches: 2 to 4 are allowed"));
}

TEST_F(Check, FindsANodeWithTooManyBranches) {
  const auto leaf = damage_.inner().child(damage_.child(0), 0);
  const std::int32_t count = 5;
  // The count is the first word of a node, three columns of lower corners before the first payload.
  std::memcpy(damage_.leaves().content(leaf, 0) - (1 + 6 * 4) * sizeof(count), &count,
              sizeof(count));
  EXPECT_THAT(failure(), HasSubstr("of level 0 has 5 branches: 2 to 4 are allowed"));
}

TEST_F(Check, FindsAnInnerRootWithOneBranch) {
  damage_.inner().truncate(damage_.root(), 1);
  EXPECT_THAT(failure(), HasSubstr("of level 2 has 1 branches: 2 to 4 are allowed"));
}

TEST_F(Check, FindsMbrcsThatAreNotTight) {
  CellBox box = damage_.inner().box(damage_.root(), 1);
  ++box.max.z();
  damage_.inner().set_box(damage_.root(), 1, box);
  EXPECT_THAT(failure(), HasSubstr("branch 1 of node "));
  EXPECT_THAT(failure(), HasSubstr("is not tight"));
}

TEST_F(Check, FindsMbrcsThatDoNotCover) {
  const auto leaf = damage_.inner().child(damage_.child(0), 0);
  damage_.leaves().set_box(leaf, 0, box_of({0, 5, 0}));
  EXPECT_THAT(failure(), HasSubstr("is not tight: its child lies from"));
}

TEST_F(Check, FindsEmptyBoxesAndBoxesBeyondTheLimits) {
  const auto leaf = damage_.inner().child(damage_.child(0), 0);
  damage_.leaves().set_box(leaf, 2, CellBox{});
  EXPECT_THAT(failure(), HasSubstr("is empty or beyond the limits"));
  damage_.leaves().set_box(leaf, 2, {.min = {0, 0, 0}, .max = {1, 1, (1 << 30) + 1}});
  EXPECT_THAT(failure(), HasSubstr("is empty or beyond the limits"));
}

TEST_F(Check, FindsANodeWithTwoParents) {
  damage_.set_child(damage_.child(0), 1, damage_.inner().child(damage_.child(0), 0));
  const std::string both = failure();
  EXPECT_THAT(both, HasSubstr("has more than one parent"));
}

TEST_F(Check, FindsANodeWithoutAParent) {
  damage_.leaves().allocate();
  EXPECT_THAT(failure(), HasSubstr("of the leaves has no parent"));
}

TEST_F(Check, FindsAnInnerNodeWithoutAParent) {
  damage_.inner().allocate();
  EXPECT_THAT(failure(), HasSubstr("of the inner nodes has no parent"));
}

TEST_F(Check, FindsAChildThatDoesNotExist) {
  damage_.set_child(damage_.root(), 0, 12345);
  EXPECT_EQ(failure(), "node 12345 of level 1 does not exist");
}

TEST_F(Check, FindsANodeThatIsFreeAndInTheTree) {
  const auto leaf = damage_.inner().child(damage_.child(0), 0);
  damage_.leaves().release(leaf);
  EXPECT_THAT(failure(), HasSubstr("is in the tree and in the list of free nodes"));
}

TEST_F(Check, FindsADamagedListOfFreeNodes) {
  const auto spare = damage_.leaves().allocate();
  damage_.leaves().append(spare, box_of({0, 0, 0}), damage_.leaves().content(0, 0));
  damage_.leaves().release(spare);
  EXPECT_EQ(failure(), "sound");
  damage_.leaves().release(spare);
  EXPECT_EQ(failure(), "the list of free leaves is damaged");
}

TEST_F(Check, FindsLeavesOnAWrongLevel) {
  ++damage_.height();  // the root's grandchildren would be inner nodes
  EXPECT_NE(failure(), "sound");
  damage_.height() = 2;  // the root's children would be leaves
  EXPECT_NE(failure(), "sound");
  damage_.height() = 0;
  EXPECT_EQ(failure(), "the height is 0, but the tree has a root");
  damage_.height() = -1;
  EXPECT_EQ(failure(), "the height is -1");
}

TEST_F(Check, FindsASubtreeOfAnotherHeight) {
  // A leaf hangs where an inner node should; there are only four of those.
  const auto leaf = damage_.inner().child(damage_.child(1), 0);
  ASSERT_EQ(leaf, 4u);
  damage_.set_child(damage_.root(), 0, leaf);
  EXPECT_EQ(failure(), "node 4 of level 1 does not exist");
}

TEST_F(Check, FindsAMissingRoot) {
  damage_.root() = NodePool::kNone;
  EXPECT_EQ(failure(), "the height is 3, but the tree has no root");
  damage_.root() = 999;
  EXPECT_EQ(failure(), "node 999 of level 2 does not exist");
}

TEST(CheckCubes, FindsACubeBeyondTheLimits) {
  BoxTree tree({.leaf_edge = 8}, sizeof(int), alignof(int));
  const int payload = 1;
  tree.insert({.min = {0, 0, 0}, .max = {8, 8, 8}}, reinterpret_cast<const std::byte*>(&payload));
  EXPECT_EQ(tree.check(), std::nullopt);
  const BoxTreeDamage damage(tree);
  const Cell min(kMaxCellIndex - 3, 0, 0);
  damage.leaves().set_box(damage.root(), 0, {.min = min, .max = min + Cell::Constant(8)});
  EXPECT_THAT(tree.check().value_or("sound"), HasSubstr("is empty or beyond the limits"));
}

}  // namespace
}  // namespace rmap
