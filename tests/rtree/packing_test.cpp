#include "rtree/packing.hpp"

#include "rtree/boxes.hpp"
#include "rtree/oracle.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Data;
using test::Random;

TEST(Packing, RunsAreFullAndNoneIsTooShort) {
  int compared = 0;
  for (const std::size_t max : {4u, 5u, 16u, 33u, 64u}) {
    for (const std::size_t min : {std::size_t{1}, max / 2}) {
      for (std::size_t count = 1; count <= 5 * max; ++count) {
        std::vector<std::size_t> runs;
        for (std::size_t left = count; left > 0; left -= runs.back()) {
          runs.push_back(next_run(left, min, max));
          ASSERT_LE(runs.back(), left);
        }
        ASSERT_EQ(runs.size(), (count + max - 1) / max);
        for (std::size_t i = 0; i < runs.size(); ++i) {
          ASSERT_LE(runs[i], max);
          if (runs.size() > 1) {
            ASSERT_GE(runs[i], min);
          }
          if (i + 2 < runs.size()) {
            ASSERT_EQ(runs[i], max);
          }
        }
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 2 * 5 * (4 + 5 + 16 + 33 + 64));
}

TEST(Packing, OrdersAreDeterministicPermutations) {
  int compared = 0;
  for (const Data data : test::kAllData) {
    for (const Packing packing : {Packing::sort_tile_recursive, Packing::hilbert}) {
      for (const int edge : {0, 1, 8}) {
        Random random(static_cast<std::uint64_t>(data));
        SCOPED_TRACE(random.trace());
        const auto boxes = test::boxes_of(data, edge, 333, random);
        auto order = packed_order(boxes, 16, packing);
        ASSERT_EQ(order, packed_order(boxes, 16, packing));
        std::sort(order.begin(), order.end());
        for (std::uint32_t i = 0; i < 333; ++i) ASSERT_EQ(order[i], i);
        ++compared;
      }
    }
  }
  EXPECT_EQ(compared, 9 * 2 * 3);
}

TEST(Packing, SortTileRecursiveTilesALattice) {
  // 8^3 cells in runs of 8: 64 runs, 4 slabs of 4 tiles of 4 runs; a run is 2 x 2 x 2 cells.
  std::vector<CellBox> boxes;
  for (int i = 0; i < 512; ++i) boxes.push_back(box_of({i / 64, i / 8 % 8, i % 8}));
  Random random(1);
  SCOPED_TRACE(random.trace());
  std::shuffle(boxes.begin(), boxes.end(), random.engine());
  const auto order = packed_order(boxes, 8, Packing::sort_tile_recursive);
  for (std::size_t first = 0; first < 512; first += 8) {
    CellBox bounds = boxes[order[first]];
    for (std::size_t i = first; i < first + 8; ++i) bounds = united(bounds, boxes[order[i]]);
    ASSERT_EQ(bounds.volume(), 8);
    ASSERT_EQ(bounds.extent(), (Eigen::Matrix<std::int64_t, 3, 1>(2, 2, 2)));
  }
}

/// The cells of a cube with one corner at `corner`, sorted along the curve.
std::vector<std::array<std::uint32_t, 3>> along_curve(std::uint32_t corner, std::uint32_t edge) {
  std::vector<std::array<std::uint32_t, 3>> points;
  for (std::uint32_t x = 0; x < edge; ++x) {
    for (std::uint32_t y = 0; y < edge; ++y) {
      for (std::uint32_t z = 0; z < edge; ++z)
        points.push_back({corner + x, corner + y, corner + z});
    }
  }
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return hilbert_less(hilbert_place(a), hilbert_place(b));
  });
  return points;
}

TEST(Packing, TheHilbertCurveStepsFromNeighbourToNeighbour) {
  int steps = 0;
  for (const std::uint32_t corner : {0u, 16u, 0x80000000u, 0x7FFFFFF0u, 0xFFFFFFF0u}) {
    const auto points = along_curve(corner, 16);
    for (std::size_t i = 1; i < points.size(); ++i, ++steps) {
      std::int64_t distance = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        distance += std::abs(std::int64_t{points[i][axis]} - std::int64_t{points[i - 1][axis]});
      }
      ASSERT_EQ(distance, 1);
    }
  }
  EXPECT_EQ(steps, 5 * (16 * 16 * 16 - 1));
}

TEST(Packing, TheHilbertCurveOfTheCoarsestCubesStepsToo) {
  // One point in each octant of the whole range: the curve visits whole octants, neighbour after
  // neighbour, so all 32 bits count.
  std::vector<std::array<std::uint32_t, 3>> points;
  for (std::uint32_t i = 0; i < 8; ++i) {
    points.push_back({(i & 1) << 31 | 0x123u, (i >> 1 & 1) << 31 | 0x7FFFFFFFu, (i >> 2) << 31});
  }
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return hilbert_less(hilbert_place(a), hilbert_place(b));
  });
  for (std::size_t i = 1; i < 8; ++i) {
    int changed = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      changed += (points[i][axis] ^ points[i - 1][axis]) >> 31 != 0 ? 1 : 0;
    }
    ASSERT_EQ(changed, 1);
  }
}

TEST(Packing, TheHilbertOrderIsThatOfTheInterleavedDigits) {
  Random random(5);
  SCOPED_TRACE(random.trace());
  const auto digits = [](const HilbertPlace& place) {
    std::vector<std::uint32_t> bits;
    for (int bit = 31; bit >= 0; --bit) {
      for (const std::uint32_t word : place) bits.push_back(word >> bit & 1);
    }
    return bits;
  };
  for (int i = 0; i < 5000; ++i) {
    HilbertPlace a;
    HilbertPlace b;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      a[axis] = static_cast<std::uint32_t>(random.engine()());
      b[axis] = random.chance(0.5) ? a[axis] : a[axis] ^ 1u << random.integer(0, 31);
    }
    ASSERT_EQ(hilbert_less(a, b), digits(a) < digits(b));
  }
}

}  // namespace
}  // namespace rmap
