#include "approximation/box_buckets.hpp"

#include "support/random.hpp"

#include <map>
#include <set>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::Random;

TEST(BoxBuckets, FindEveryBoxNearby) {
  Random random(1);
  SCOPED_TRACE(random.trace());
  BoxBuckets buckets;
  std::map<std::uint32_t, CellBox> plain;
  int found = 0;
  for (std::uint32_t step = 0; step < 1500; ++step) {
    if (random.chance(0.6) || plain.empty()) {
      plain[step] = random.box(-60, 60, 25);
      buckets.add(step, plain[step]);
    } else {
      const auto removed = plain.lower_bound(static_cast<std::uint32_t>(random.engine()()) % step);
      if (removed != plain.end()) {
        buckets.remove(removed->first, removed->second);
        plain.erase(removed);
      }
    }
    const CellBox asked = random.box(-90, 70, 20);
    std::set<std::uint32_t> near;
    buckets.for_each_near(asked, [&](std::uint32_t number) { near.insert(number); });
    for (const auto& [number, box] : plain) {
      // Those in the same blocks of eight cells, and no others.
      const CellBox blocks{.min = block_origin(asked.min),
                           .max = block_origin(asked.max - Cell::Ones()) + Cell::Constant(8)};
      ASSERT_EQ(near.contains(number), box.overlaps(blocks));
      found += near.contains(number) ? 1 : 0;
    }
    for (const std::uint32_t number : near) ASSERT_TRUE(plain.contains(number));
  }
  EXPECT_GT(found, 1000);
}

}  // namespace
}  // namespace rmap
