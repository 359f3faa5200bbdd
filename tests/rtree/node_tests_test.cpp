#include "rtree/node_tests.hpp"

#include "rtree/boxes.hpp"
#include "rtree/oracle.hpp"
#include "support/simd_targets.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include <rmap/block.hpp>
#include <rmap/rtree/node_pool.hpp>

namespace rmap {
namespace {

using test::Data;
using test::Random;

/// A full node of the first `count` boxes, or one that has as few branches as a tree allows.
struct Node {
  Node(const std::vector<CellBox>& all, int edge, int count)
      : boxes(all.begin(), all.begin() + count), pool(std::max(count, 4), edge, 4, 4) {
    id = pool.allocate();
    for (const CellBox& box : boxes) {
      const std::uint32_t content = 7;
      pool.append(id, box, reinterpret_cast<const std::byte*>(&content));
    }
  }

  template <class Wanted>
  std::uint64_t plain(const Wanted& wanted) const {
    std::uint64_t mask = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (wanted(boxes[i])) mask |= std::uint64_t{1} << i;
    }
    return mask;
  }
  BranchColumns columns() const { return pool.columns(id); }
  CellBox bounds() const { return boxes.empty() ? CellBox{} : pool.bounds(id); }

  std::vector<CellBox> boxes;
  NodePool pool;
  std::uint32_t id;
};

/// Calls use(node, random) with nodes of all sizes and kinds; returns how many.
template <class Use>
int for_each_node(const Use& use) {
  int nodes = 0;
  for (const Data data : test::kAllData) {
    for (const int edge : {0, 1, 8}) {
      Random random(static_cast<std::uint64_t>(data) * 10 + static_cast<std::uint64_t>(edge));
      SCOPED_TRACE(random.trace());
      const auto boxes = test::boxes_of(data, edge, kMaxBranches, random);
      for (const int count : {0, 1, 3, 4, 7, 8, 9, 16, 33, 63, 64}) {
        use(Node(boxes, edge, count), random);
        if (testing::Test::HasFatalFailure()) return nodes;
        ++nodes;
      }
    }
  }
  return nodes;
}
constexpr int kNodes = 9 * 3 * 11;

TEST(NodeTests, BoxesEqualThePlainTests) {
  test::for_each_simd_target([](const char* target) {
    SCOPED_TRACE(target);
    int compared = 0;
    const int nodes = for_each_node([&](const Node& node, Random& random) {
      const BranchColumns columns = node.columns();
      ASSERT_EQ(node_tests::all(columns), node.plain([](const CellBox&) { return true; }));
      for (int i = 0; i < 30; ++i) {
        const bool own = i % 5 == 0 && !node.boxes.empty();
        const CellBox region = own ? node.boxes[static_cast<std::size_t>(i) % node.boxes.size()]
                                   : test::region_of(node.bounds(), random);
        if (region.empty()) continue;
        ASSERT_EQ(node_tests::overlapping(columns, region),
                  node.plain([&](const CellBox& box) { return box.overlaps(region); }));
        ASSERT_EQ(node_tests::contained_in(columns, region),
                  node.plain([&](const CellBox& box) { return region.contains(box); }));
        ASSERT_EQ(node_tests::enclosing(columns, region),
                  node.plain([&](const CellBox& box) { return box.contains(region); }));
        ASSERT_EQ(node_tests::equal_to(columns, region),
                  node.plain([&](const CellBox& box) { return box == region; }));
        ++compared;
      }
    });
    EXPECT_EQ(nodes, kNodes);
    EXPECT_GT(compared, kNodes * 20);
  });
}

TEST(NodeTests, BeamsEqualTheDefinitionBitForBit) {
  test::for_each_simd_target([](const char* target) {
    SCOPED_TRACE(target);
    int crossings = 0;
    int few = 0;  // branches that are only touched, and may be crossed as far as can be told
    const int nodes = for_each_node([&](const Node& node, Random& random) {
      for (int i = 0; i < 6 * test::kBeamKinds; ++i) {
        const Beam beam = test::beam_of(i % test::kBeamKinds, node.bounds(), random);
        node_tests::Measures enter;
        const std::uint64_t mask = node_tests::crossed(node.columns(), beam, enter);
        ASSERT_EQ(mask, node.plain([&](const CellBox& box) { return crossing(beam, box); }));
        node_tests::Measures earliest;
        const std::uint64_t may =
            node_tests::may_cross(node.columns(), beam, beam.direction().cwiseInverse(), earliest);
        ASSERT_EQ(may & mask, mask);
        few += static_cast<int>(bit_count(may)) - static_cast<int>(bit_count(mask));
        for (std::size_t branch = 0; branch < node.boxes.size(); ++branch) {
          if ((mask >> branch & 1) == 0) continue;
          ASSERT_EQ(enter[branch], crossing(beam, node.boxes[branch])->enter);
          ASSERT_LE(earliest[branch], enter[branch]);
          ASSERT_GE(earliest[branch], enter[branch] * (1 - 0x1p-48));
          ++crossings;
        }
        // What is behind the node's MBRC may count on it.
        const auto whole = node.boxes.empty() ? std::nullopt : crossing(beam, node.bounds());
        ASSERT_TRUE(mask == 0 || whole);
        for (std::size_t branch = 0; branch < node.boxes.size(); ++branch) {
          if ((mask >> branch & 1) != 0) {
            ASSERT_LE(whole->enter, enter[branch]);
          }
        }
      }
    });
    EXPECT_EQ(nodes, kNodes);
    EXPECT_GT(crossings, 10000);
    EXPECT_LT(few, crossings);
  });
}

TEST(NodeTests, DistancesEqualThePlainOnes) {
  int compared = 0;
  const int nodes = for_each_node([&](const Node& node, Random& random) {
    for (int i = 0; i < 10; ++i) {
      Vector3d point = test::cell_of(node.bounds(), random).cast<double>();
      if (i % 2 == 0) point += random.point(0, 1);
      node_tests::Measures squared;
      node_tests::squared_distances(node.columns(), point, squared);
      for (std::size_t branch = 0; branch < node.boxes.size(); ++branch) {
        ASSERT_EQ(squared[branch], test::squared_distance(point, node.boxes[branch]));
        ASSERT_LE(test::squared_distance(point, node.bounds()), squared[branch]);
        ++compared;
      }
    }
  });
  EXPECT_EQ(nodes, kNodes);
  EXPECT_EQ(compared, 9 * 3 * 10 * (1 + 3 + 4 + 7 + 8 + 9 + 16 + 33 + 63 + 64));
}

TEST(NodeTests, EnlargementsAreThoseOfTheVolumes) {
  const int nodes = for_each_node([&](const Node& node, Random& random) {
    CellBox box = test::region_of(node.bounds(), random);
    if (box.empty()) box = all_cells();
    node_tests::Measures volume;
    node_tests::Measures enlargement;
    node_tests::enlargements(node.columns(), box, volume, enlargement);
    for (std::size_t branch = 0; branch < node.boxes.size(); ++branch) {
      const double own = node.boxes[branch].volume();
      const double together = united(node.boxes[branch], box).volume();
      // Products of three edges round twice, CellBox::volume once.
      ASSERT_NEAR(volume[branch], own, own * 0x1p-51);
      ASSERT_NEAR(enlargement[branch], together - own, together * 0x1p-50);
      ASSERT_GE(enlargement[branch], 0);
    }
  });
  EXPECT_EQ(nodes, kNodes);
}

}  // namespace
}  // namespace rmap
