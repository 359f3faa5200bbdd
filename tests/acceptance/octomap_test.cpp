// Against liboctomap with the same float32 points and parameters: complete history
// gives its occupied cells, first-hit history those and a few more.
#include "support/octomap_leaves.hpp"
#include "support/octomap_twin.hpp"
#include "support/real_data.hpp"
#include "support/scans.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <tuple>

#include <gtest/gtest.h>

#include <rmap/cells.hpp>
#include <rmap/grid.hpp>
#include <rmap/octomap_file.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using CellSet = std::set<Cell, test::MortonOrder>;

// At the finer resolution OctoMap takes its time: about so many beams, of all scans, do.
constexpr std::size_t kBeamsAtFine = 100000;

// How near to the border of a cell OctoMap may take the other side, in cells: it rounds the
// directions of beams to float32.
constexpr double kSlack = 1e-5;

class AgainstOctoMap : public testing::TestWithParam<std::tuple<std::string, double>> {
 protected:
  void SetUp() override {
    const auto& [name, resolution] = GetParam();
    const auto folder = test::sequence_folder(name);
    if (folder.empty()) GTEST_SKIP() << "the sequence " << name << " is not there: set RMAP_DATA";
    std::size_t points = 0;
    for (const Scan& scan : read_scans(folder)) {
      scans_.push_back(test::in_map_frame(scan));
      points += scan.points.size();
    }
    const std::size_t stride =
        resolution < 0.2 ? std::max<std::size_t>(1, points / kBeamsAtFine) : 1;
    for (Scan& scan : scans_) {
      scan = test::thinned(scan, stride);
      beams_ += scan.points.size();
    }
  }

  std::vector<Scan> scans_;
  std::size_t beams_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Sequences, AgainstOctoMap,
                         testing::Combine(testing::ValuesIn(test::sequence_names()),
                                          testing::Values(0.2, 0.1)),
                         [](const auto& sequence) {
                           return std::get<0>(sequence.param) +
                                  (std::get<1>(sequence.param) == 0.2 ? "_coarse" : "_fine");
                         });

CellSet occupied_cells(const Grid& grid) {
  CellSet occupied;
  for (const auto& [cell, value] : cells(grid, {.occupied_only = true})) occupied.insert(cell);
  return occupied;
}

// The cells of `a` that are none of `b`.
std::vector<Cell> missing(const CellSet& a, const CellSet& b) {
  std::vector<Cell> cells;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(cells),
                      morton_less);
  return cells;
}

// Whether the segment from `origin` to `end` passes through the inside of a box.
bool passes(const Vector3d& origin, const Vector3d& end, const Box& box) {
  double enter = 0;
  double leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double along = end[axis] - origin[axis];
    if (along == 0) {
      if (origin[axis] <= box.min[axis] || origin[axis] >= box.max[axis]) return false;
      continue;
    }
    const double at_min = (box.min[axis] - origin[axis]) / along;
    const double at_max = (box.max[axis] - origin[axis]) / along;
    enter = std::max(enter, std::min(at_min, at_max));
    leave = std::min(leave, std::max(at_min, at_max));
  }
  return enter < leave;
}

// Whether a beam ends so near to a border of the cell, or grazes it so, that rounding decides.
bool on_the_border(const Vector3d& origin, const Vector3d& end, const Cell& cell) {
  const Vector3d low = cell.cast<double>();
  const Box outer{.min = low.array() - kSlack, .max = low.array() + (1 + kSlack)};
  const Box inner{.min = low.array() + kSlack, .max = low.array() + (1 - kSlack)};
  return passes(origin, end, outer) != passes(origin, end, inner) ||
         outer.contains(end) != inner.contains(end);
}

bool explained(const Cell& cell, const std::vector<Scan>& scans, const Lattice& lattice) {
  return std::any_of(scans.begin(), scans.end(), [&](const Scan& scan) {
    const Vector3d origin = lattice.to_cells(scan.map_from_sensor.translation());
    return std::any_of(scan.points.begin(), scan.points.end(), [&](const Vector3f& point) {
      return on_the_border(origin, lattice.to_cells(point.cast<double>()), cell);
    });
  });
}

// Its file is our map of its occupied leaves, and ours its map of our cells.
void expect_files_agree(const Grid& grid, octomap::OcTree& tree, const CellSet& theirs) {
  const std::filesystem::path folder(testing::TempDir());
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const auto file = folder / ("rmap_" + std::to_string(std::hash<std::string>()(test)) + ".ot");
  tree.prune();
  ASSERT_TRUE(tree.write(file.string()));
  const OctomapImport map = import_octomap(file);
  EXPECT_EQ(map.clamped_leaves + map.changed_leaves, 0u);
  EXPECT_EQ(occupied_cells(map.grid), theirs);
  test::expect_same_leaves(map.grid, tree);

  export_octomap(grid, file);
  const std::unique_ptr<octomap::OcTree> ours(
      dynamic_cast<octomap::OcTree*>(octomap::AbstractOcTree::read(file.string())));
  std::filesystem::remove(file);
  ASSERT_TRUE(ours);
  test::expect_same_leaves(grid, *ours);
  EXPECT_EQ(test::occupied_cells(*ours), occupied_cells(grid));
}

TEST_P(AgainstOctoMap, OccupiedCellsAreTheSame) {
  const Options options{.resolution = std::get<1>(GetParam())};
  Grid complete(options);
  Grid first_hit(options);
  octomap::OcTree tree(options.resolution);
  for (const Scan& scan : scans_) complete.prepare(scan);
  for (const Scan& scan : scans_) {
    complete.insert(scan);
    first_hit.insert(scan);
    test::insert_into(tree, scan);
  }
  const CellSet theirs = test::occupied_cells(tree);
  const CellSet ours = occupied_cells(complete);
  const CellSet with_first_hit = occupied_cells(first_hit);
  ASSERT_GT(theirs.size(), 200u);

  const std::size_t allowed = beams_ * 10 / 1000000;  // cells on whose borders rounding decides
  std::vector<Cell> different = missing(theirs, ours);
  const std::vector<Cell> more = missing(ours, theirs);
  different.insert(different.end(), more.begin(), more.end());
  EXPECT_LE(different.size(), allowed);
  for (const Cell& cell : different) {
    EXPECT_TRUE(explained(cell, scans_, complete.lattice())) << cell.transpose();
  }
  EXPECT_LE(missing(theirs, with_first_hit).size(), allowed);
  EXPECT_GE(missing(with_first_hit, theirs).size(), more.size());
  expect_files_agree(complete, tree, theirs);
  RecordProperty("beams", static_cast<int>(beams_));
  RecordProperty("occupied", static_cast<int>(theirs.size()));
  RecordProperty("different", static_cast<int>(different.size()));
  RecordProperty("more_with_first_hit", static_cast<int>(missing(with_first_hit, theirs).size()));
}

}  // namespace
}  // namespace rmap
