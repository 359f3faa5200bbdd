// What the paper's experiments show on real sequences, where these are.
#include "evaluation/checks.hpp"
#include "evaluation/map_under_test.hpp"
#include "support/real_data.hpp"

#include <gtest/gtest.h>

#include <rmap/scan_source.hpp>

namespace rmap::evaluation {
namespace {

Sequence real_sequence(const std::string& name, const std::filesystem::path& folder) {
  return read_sequence(name, *open_scans(folder), 0);
}

class RealAccuracy : public testing::TestWithParam<const char*> {};

// At 0.2 m: complete history never below OctoMap, first-hit history at most 0.5 points.
TEST_P(RealAccuracy, is_no_less_than_octomaps) {
  if (octomap_version().empty()) GTEST_SKIP() << "built without OctoMap";
  const std::filesystem::path folder = test::sequence_folder(GetParam());
  if (folder.empty()) GTEST_SKIP() << GetParam() << " is not here";
  const auto rows = accuracy_experiment(real_sequence(GetParam(), folder), 0.2);
  for (const double threshold : {0.9, 0.5}) {
    const AccuracyRow* octomap = find_row(rows, GetParam(), kOctomap, 0.2, threshold);
    const AccuracyRow* complete = find_row(rows, GetParam(), kComplete, 0.2, threshold);
    const AccuracyRow* first_hit = find_row(rows, GetParam(), kFirstHit, 0.2, threshold);
    ASSERT_TRUE(octomap && complete && first_hit);
    EXPECT_GE(complete->balanced(), octomap->balanced());
    EXPECT_GE(first_hit->balanced(), octomap->balanced() - 0.5);
  }
}

INSTANTIATE_TEST_SUITE_P(Sequences, RealAccuracy,
                         testing::Values("street_kitti", "hall_lidar", "livingroom_depth",
                                         "kitchen_depth", "corridor_tilt", "corridor_2d"),
                         [](const auto& one) { return std::string(one.param); });

struct WantedMemory {
  const char* sequence;
  double times;
};

class RealMemory : public testing::TestWithParam<WantedMemory> {};

// At 0.1 m, against OctoMap's uncompressed tree by the paper's formula.
TEST_P(RealMemory, is_many_times_less_than_octomaps) {
  if (octomap_version().empty()) GTEST_SKIP() << "built without OctoMap";
  const auto& [name, times] = GetParam();
  const std::filesystem::path folder = test::sequence_folder(name);
  if (folder.empty()) GTEST_SKIP() << name << " is not here";
  const GridFindings findings = grid_experiment(
      real_sequence(name, folder), {.resolution = 0.1, .samples = 1, .repetitions = 1});
  const auto theirs = static_cast<double>(*findings.references.back().uncompressed);
  for (const char* map : {kBlocks, kBlocksComplete}) {
    EXPECT_GE(theirs / static_cast<double>(*findings.find(map)->last().bytes), times) << map;
  }
}

INSTANTIATE_TEST_SUITE_P(Sequences, RealMemory,
                         testing::Values(WantedMemory{"street_kitti", 150},
                                         WantedMemory{"hall_lidar", 100},
                                         WantedMemory{"kitchen_depth", 1},
                                         WantedMemory{"corridor_2d", 1}),
                         [](const auto& one) { return std::string(one.param.sequence); });

}  // namespace
}  // namespace rmap::evaluation
