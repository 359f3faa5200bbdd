// The findings of the paper on little of the simulated campus: each is shown by the results, and by
// none where the two sides of the comparison have changed places. No times are asserted but one,
// which OctoMap's going over all free leaves loses by orders of magnitude.
#include "evaluation/checks.hpp"
#include "evaluation/map_under_test.hpp"

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rmap::evaluation {
namespace {

constexpr std::size_t kFewScans = 6;
// As many as --quick takes.
constexpr std::size_t kManyScans = 40;
constexpr double kResolution = 0.2;

void expect_shown(const std::vector<Check>& checks, std::size_t least) {
  std::size_t judged = 0;
  for (const Check& check : checks) {
    if (!check.judged) continue;
    ++judged;
    EXPECT_TRUE(check.holds) << check.claim << " [" << check.subject << "]: " << check.shown;
  }
  EXPECT_GE(judged, least);
}

void expect_refuted(const std::vector<Check>& checks, std::size_t least) {
  std::size_t judged = 0;
  for (const Check& check : checks) {
    if (!check.judged) continue;
    ++judged;
    EXPECT_FALSE(check.holds) << check.claim << " [" << check.subject << "]: " << check.shown;
  }
  EXPECT_GE(judged, least);
}

bool has_octomap() { return !octomap_version().empty(); }

TEST(Findings, RTreesOfLargerM) {
  std::vector<RTreeRow> rows =
      rtree_experiment(campus_sequence(kManyScans), {.resolution = kResolution, .repetitions = 1});
  ASSERT_EQ(rows.size(), 2u * 5 * 3);
  expect_shown(check_rtree(rows), 7);

  // Large M and small M change places.
  for (RTreeRow& row : rows) row.max_branches = 256 / row.max_branches;
  std::stable_sort(rows.begin(), rows.end(), [](const RTreeRow& a, const RTreeRow& b) {
    return a.max_branches < b.max_branches;
  });
  expect_refuted(check_rtree(rows), 7);
}

TEST(Findings, BulkLoadedTreesHaveFewestNodes) {
  const std::vector<RTreeRow> rows =
      rtree_experiment(campus_sequence(kFewScans), {.resolution = kResolution, .repetitions = 1});
  for (const RTreeRow& bulk : rows) {
    if (bulk.built != "bulk") continue;
    for (const RTreeRow& row : rows) {
      if (row.built == "bulk" || row.leaves != bulk.leaves ||
          row.max_branches != bulk.max_branches) {
        continue;
      }
      EXPECT_LT(bulk.nodes, row.nodes);
      EXPECT_EQ(bulk.items, row.items);
    }
  }
}

// The maps of both sides in each other's place.
GridFindings swapped(const GridFindings& findings) {
  GridFindings other = findings;
  const GridRun& ours = *findings.find(kBlocks);
  const GridRun& theirs = *findings.find(kOctomapRun);
  for (GridRun& run : other.runs) run.samples = run.is_octomap ? ours.samples : theirs.samples;
  GridFindings::Reference& last = other.references.back();
  last.uncompressed = last.pruned = last.maximum_likelihood = *ours.last().bytes;
  last.full_grid = *ours.last().bytes;
  return other;
}

HistoryRow swapped(const HistoryRow& row) {
  HistoryRow other = row;
  std::swap(other.first_hit_occupied, other.complete_occupied);
  std::swap(other.false_cells, other.lost_cells);
  if (other.octomap) std::swap(other.octomap->first_hit_false, other.octomap->only_complete);
  return other;
}

TEST(Findings, MapsAreSmallerAndGoneOverFasterThanOctoMaps) {
  if (!has_octomap()) GTEST_SKIP() << "built without OctoMap";
  const GridFindings findings =
      grid_experiment(campus_sequence(kFewScans), {.resolution = kResolution, .repetitions = 3});
  expect_shown(check_grid(findings), 20);
  expect_refuted(check_grid(swapped(findings)), 20);
  expect_shown(check_history(findings.history), 2);
  expect_refuted(check_history(swapped(findings.history)), 2);

  // Every scan has its time, some have all figures, the last among them.
  for (const GridRun& run : findings.runs) {
    ASSERT_EQ(run.samples.size(), kFewScans);
    EXPECT_GT(run.insert_ms(), 0);
    EXPECT_TRUE(run.last().bytes && run.last().occupied && run.last().extract_ms);
  }
  EXPECT_EQ(findings.references.back().scan, kFewScans);
  const GridFindings::Reference& last = findings.references.back();
  EXPECT_GT(last.uncompressed, last.pruned);
  EXPECT_GT(last.pruned, last.maximum_likelihood);
  // The paper's layout holds the same map.
  EXPECT_EQ(findings.find("cells, M = 8")->last().occupied,
            findings.find(kBlocks)->last().occupied);
}

std::vector<AccuracyRow> swapped(std::vector<AccuracyRow> rows, const char* a, const char* b) {
  for (AccuracyRow& row : rows) {
    if (row.map == a) {
      row.map = b;
    } else if (row.map == b) {
      row.map = a;
    }
  }
  return rows;
}

TEST(Findings, NinetyNinePercentOfTheCellsAreRight) {
  const std::vector<AccuracyRow> rows =
      accuracy_experiment(campus_sequence(kManyScans), kResolution);
  const auto check = [](const std::vector<AccuracyRow>& of) {
    return check_accuracy(of, "campus", kResolution, true);
  };
  expect_shown(check(rows), has_octomap() ? 6 : 2);
  // A map that holds nothing does not pass.
  for (const char* ours : {kFirstHit, kComplete}) {
    const std::vector<Check> checks = check(swapped(rows, ours, kEmptyMap));
    EXPECT_TRUE(std::any_of(checks.begin(), checks.end(),
                            [](const Check& one) { return one.judged && !one.holds; }));
  }
  if (!has_octomap()) return;
  // Each claim names one of ours: all that name the one that was swapped must fail.
  for (const char* ours : {kFirstHit, kComplete}) {
    std::vector<Check> checks = check(swapped(rows, ours, kOctomap));
    const bool is_complete = std::string(ours) == kComplete;
    std::erase_if(checks, [&](const Check& one) {
      return (one.claim.find("complete history") != std::string::npos) != is_complete;
    });
    expect_refuted(checks, 3);
  }
}

TEST(Findings, ShortSequencesAreNotJudged) {
  const std::vector<AccuracyRow> rows = accuracy_experiment(campus_sequence(3), 0.4);
  ASSERT_FALSE(rows.empty());
  for (const AccuracyRow& row : rows) {
    EXPECT_FALSE(row.judged);
    EXPECT_EQ(row.scans_held_out, 1u);
    EXPECT_EQ(row.scans_inserted, 2u);
    if (row.map != kEmptyMap) continue;
    EXPECT_EQ(row.balanced(), 50);
    EXPECT_GT(row.percentage(), 90);
  }
  EXPECT_TRUE(accuracy_experiment(campus_sequence(1), 0.4).empty());
}

TEST(Findings, QueryCuboidsAreFewerAndCoarserFarAway) {
  MultiresolutionFindings findings = multiresolution_experiment(campus_sequence(1), 0.1);
  expect_shown(check_multiresolution(findings), 2);
  std::size_t cuboids = 0;
  for (const auto& size : findings.sizes) cuboids += size.cuboids;
  EXPECT_EQ(cuboids, findings.boxes.size());

  std::swap(findings.cells, findings.cuboids);
  std::reverse(findings.sizes.begin(), findings.sizes.end());
  expect_refuted(check_multiresolution(findings), 2);
}

TEST(Findings, CuboidsTakeLessThanPointsAndFollowSigmaAndOmega) {
  const std::vector<CloudScene> clouds = simulated_clouds(0);
  ASSERT_EQ(clouds.size(), 2u);
  for (const CloudScene& cloud : clouds) {
    SCOPED_TRACE(cloud.name);
    CuboidFindings findings;
    cuboid_experiment(cloud, 1, findings);
    const std::vector<Check> checks = check_cuboids(findings, cloud.name);
    expect_shown(checks, 9);

    // Cuboids and what they are compared with, and both ends of each curve, change places.
    CloudBytes& others = findings.clouds.front();
    const std::uint64_t least = std::min(others.raw_points, others.octomap);
    std::uint64_t ours = 0;
    for (CuboidRow& row : findings.rows) {
      if (row.sigma == 0.95) ours = std::max(ours, row.bytes);
      row.bytes = least;
      std::swap(row.rtree_bytes[0], row.rtree_bytes[2]);
    }
    EXPECT_GT(ours, 1000u);
    others.raw_points = others.octomap = ours;
    std::vector<CuboidRow> reversed(findings.rows.rbegin(), findings.rows.rend());
    findings.rows = reversed;
    std::vector<Check> refuted = check_cuboids(findings, cloud.name);
    EXPECT_EQ(refuted.size(), checks.size());
    expect_refuted(refuted, 9);
  }
}

}  // namespace
}  // namespace rmap::evaluation
