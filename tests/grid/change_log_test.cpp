#include "grid/change_log.hpp"

#include <gtest/gtest.h>

namespace rmap {
namespace {

TEST(BoundedLog, ForgetsTheOldestAndKnowsIt) {
  BoundedLog log(3);
  for (int i = 1; i <= 5; ++i) log.add({i, 0, 0}, static_cast<std::uint64_t>(i));
  EXPECT_EQ(log.since(2), (std::vector<Cell>{{3, 0, 0}, {4, 0, 0}, {5, 0, 0}}));
  EXPECT_EQ(log.since(4), (std::vector<Cell>{{5, 0, 0}}));
  EXPECT_TRUE(log.reaches_back_to(2));
  EXPECT_FALSE(log.reaches_back_to(1));
}

TEST(BoundedLog, NamesEachCellOnce) {
  BoundedLog log(10);
  for (std::uint64_t revision = 1; revision < 6; ++revision) log.add({1, 2, 3}, revision);
  EXPECT_EQ(log.since(0), (std::vector<Cell>{{1, 2, 3}}));
}

TEST(ChangeLog, StampsNameRevisions) {
  ChangeLog log;
  EXPECT_TRUE(log.begin());
  EXPECT_EQ(log.revision(), 1u);
  EXPECT_EQ(log.revision_of(log.stamp()), 1u);
  EXPECT_TRUE(log.knows_blocks_since(0));
  EXPECT_FALSE(log.knows_flips_since(0));
  log.track_flips(10);
  EXPECT_TRUE(log.begin());
  log.flipped({4, 5, 6});
  EXPECT_TRUE(log.knows_flips_since(1));
  EXPECT_FALSE(log.knows_flips_since(0));
  EXPECT_EQ(log.flipped_since(1), (std::vector<Cell>{{4, 5, 6}}));
}

TEST(ChangeLog, SaysWhenStampsRunOut) {
  ChangeLog log;
  log.start_at((std::uint64_t{1} << 32) - 2);
  EXPECT_TRUE(log.begin());
  log.lost_cells({8, 8, 8});
  EXPECT_EQ(log.revision_of(log.stamp()), log.revision());
  EXPECT_FALSE(log.begin());  // the caller sets older stamps to 0
  EXPECT_EQ(log.revision(), std::uint64_t{1} << 32);
  EXPECT_EQ(log.stamp(), 1u);
  EXPECT_EQ(log.revision_of(log.stamp()), log.revision());
  EXPECT_FALSE(log.knows_blocks_since(log.revision() - 2));
  EXPECT_TRUE(log.knows_blocks_since(log.revision() - 1));
  EXPECT_TRUE(log.blocks_with_losses_since(0).empty());
}

}  // namespace
}  // namespace rmap
