#include "evaluation/history_experiment.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace rmap::evaluation {
namespace {

TEST(History, CountsCellsThatOneSideHas) {
  const std::vector<Cell> first_hit{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Cell> complete{{0, 0, 0}, {0, 1, 0}};
  const std::vector<Cell> octomap{{0, 0, 0}, {1, 1, 0}};
  const HistoryRow row = compare_histories(first_hit, complete, &octomap);
  EXPECT_EQ(row.first_hit_occupied, 3u);
  EXPECT_EQ(row.complete_occupied, 2u);
  EXPECT_EQ(row.false_cells, 1u);
  EXPECT_EQ(row.lost_cells, 0u);
  EXPECT_DOUBLE_EQ(row.false_percent(), 50);
  ASSERT_TRUE(row.octomap);
  EXPECT_EQ(row.octomap->occupied, 2u);
  EXPECT_EQ(row.octomap->only_octomap, 1u);
  EXPECT_EQ(row.octomap->only_complete, 1u);
  EXPECT_EQ(row.octomap->first_hit_false, 2u);
}

TEST(History, DoesWithoutOctoMap) {
  const std::vector<Cell> cells{{0, 0, 0}};
  const HistoryRow row = compare_histories(cells, cells, nullptr);
  EXPECT_FALSE(row.octomap);
  EXPECT_TRUE(to_json(row)["octomap_occupied"].is_null());
}

}  // namespace
}  // namespace rmap::evaluation
