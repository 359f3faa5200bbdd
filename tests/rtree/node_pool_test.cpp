#include "support/random.hpp"

#include <cstring>

#include <gtest/gtest.h>

#include <rmap/rtree/node_pool.hpp>

namespace rmap {
namespace {

using test::Random;

struct Plain {
  CellBox box;
  double content;
};

void expect_same(const NodePool& pool, std::uint32_t node, const std::vector<Plain>& expected) {
  ASSERT_EQ(pool.count(node), static_cast<int>(expected.size()));
  for (int i = 0; i < pool.count(node); ++i) {
    const Plain& plain = expected[static_cast<std::size_t>(i)];
    ASSERT_EQ(pool.box(node, i), plain.box);
    double content = 0;
    std::memcpy(&content, pool.content(node, i), sizeof(content));
    ASSERT_EQ(content, plain.content);
    ASSERT_EQ(reinterpret_cast<std::uintptr_t>(pool.content(node, i)) % alignof(double), 0u);
    const BranchColumns columns = pool.columns(node);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_EQ(columns.min[axis][i], plain.box.min[static_cast<int>(axis)]);
      ASSERT_EQ(columns.max[axis][i] + columns.added, plain.box.max[static_cast<int>(axis)]);
    }
  }
}

TEST(NodePool, EqualsAListOfBranches) {
  int compared = 0;
  for (const int max_branches : {4, 5, 33, 64}) {
    for (const int edge : {0, 8}) {
      Random random(static_cast<std::uint64_t>(max_branches + edge));
      SCOPED_TRACE(random.trace());
      NodePool pool(max_branches, edge, sizeof(double), alignof(double));
      pool.allocate();
      const auto node = pool.allocate();
      pool.allocate();
      std::vector<Plain> expected;
      for (int i = 0; i < 300; ++i, ++compared) {
        const int last = static_cast<int>(expected.size()) - 1;
        CellBox box = random.box(-50, 50, 9);
        if (edge > 0) box.max = box.min + Cell::Constant(edge);
        if (last < 0 || (!pool.full(node) && random.chance(0.6))) {
          const double content = random.real(0, 1);
          pool.append(node, box, reinterpret_cast<const std::byte*>(&content));
          expected.push_back({box, content});
        } else if (random.chance(0.5)) {
          const int branch = random.integer(0, last);
          pool.remove(node, branch);
          expected[static_cast<std::size_t>(branch)] = expected.back();
          expected.pop_back();
        } else {
          const int branch = random.integer(0, last);
          pool.set_box(node, branch, box);
          expected[static_cast<std::size_t>(branch)].box = box;
        }
        ASSERT_NO_FATAL_FAILURE(expect_same(pool, node, expected));
        if (expected.empty()) continue;
        CellBox bounds = expected[0].box;
        for (const Plain& plain : expected) bounds = united(bounds, plain.box);
        ASSERT_EQ(pool.bounds(node), bounds);
      }
      EXPECT_EQ(pool.count(0), 0);
      EXPECT_EQ(pool.count(2), 0);
    }
  }
  EXPECT_EQ(compared, 4 * 2 * 300);
}

TEST(NodePool, CubesTakeHalfTheColumns) {
  NodePool with_boxes(64, 0, 4, 4);
  NodePool with_cubes(64, 8, 4, 4);
  with_boxes.allocate();
  with_cubes.allocate();
  // 4 + 64 * (24 + 4) = 1796 bytes, 8 a page; 4 + 64 * (12 + 4) = 1028 bytes, 8 a page.
  EXPECT_EQ(with_boxes.bytes_in_use(), 8UL * 1796 + sizeof(void*));
  EXPECT_EQ(with_cubes.bytes_in_use(), 8UL * 1028 + sizeof(void*));
}

}  // namespace
}  // namespace rmap
