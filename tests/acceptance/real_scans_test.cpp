// Real scans: both layouts, shuffled points and the brute-force oracle agree bit for bit.
#include "support/grids.hpp"
#include "support/plain_grid.hpp"
#include "support/real_data.hpp"
#include "support/scans.hpp"
#include "support/simd_targets.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <rmap/grid.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::PlainGrid;
using test::Random;

class RealScans : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const auto folder = test::sequence_folder(GetParam());
    if (folder.empty()) {
      GTEST_SKIP() << "the sequence " << GetParam() << " is not there: set RMAP_DATA";
    }
    for (const Scan& scan : read_scans(folder)) scans_.push_back(scan);
    for (const Scan& scan : scans_) points_ += scan.points.size();
  }

  std::vector<Scan> scans_;
  std::size_t points_ = 0;
};

INSTANTIATE_TEST_SUITE_P(Sequences, RealScans, testing::ValuesIn(test::sequence_names()),
                         [](const auto& sequence) { return sequence.param; });

TEST_P(RealScans, ThinnedTo2000BeamsGiveTheMapOfTheDefinition) {
  Random random(71);
  SCOPED_TRACE(random.trace());
  const std::size_t stride = std::max<std::size_t>(1, points_ / 2000);
  std::uint64_t misses = 0;
  for (const bool complete : {false, true}) {
    const Options options{.resolution = 0.2};
    PlainGrid plain(options);
    Grid blocks(options);
    Grid cells({.resolution = 0.2, .layout = Layout::cells, .threads = 2});
    std::size_t beams = 0;
    if (complete) {
      for (const Scan& scan : scans_) {
        const Scan thin = test::thinned(scan, stride);
        plain.prepare(thin);
        blocks.prepare(thin);
        cells.prepare(thin);
      }
    }
    for (const Scan& scan : scans_) {
      const Scan thin = test::thinned(scan, stride);
      beams += thin.points.size();
      const InsertReport expected = plain.insert(thin);
      misses += expected.misses;
      ASSERT_EQ(blocks.insert(thin), expected);
      ASSERT_EQ(cells.insert(test::shuffled(thin, random)), expected);
    }
    EXPECT_GE(beams, 1900u);
    EXPECT_EQ(test::difference(blocks, plain), "");
    EXPECT_EQ(test::difference(cells, plain), "");
    EXPECT_TRUE(same_map(blocks, cells));
    EXPECT_EQ(blocks.history(), complete ? History::complete : History::first_hit);
  }
  EXPECT_GT(misses, 20u);
}

// Every beam of the sequence against 5,000 of its cells, one by one.
TEST_P(RealScans, AllBeamsTreat5000CellsAsTheDefinitionSays) {
  Random random(72);
  SCOPED_TRACE(random.trace());
  const Options options{.resolution = 0.2};
  Grid grid(options);
  for (const Scan& scan : scans_) grid.prepare(scan);
  auto cells = test::all_cell_values(grid);
  std::shuffle(cells.begin(), cells.end(), random.engine());
  std::set<Cell, test::MortonOrder> followed;
  for (std::size_t i = 0; i < std::min<std::size_t>(5000, cells.size()); ++i) {
    followed.insert(cells[i].cell);
  }
  PlainGrid plain(options, followed);
  for (const Scan& scan : scans_) plain.prepare(scan);
  for (const Scan& scan : scans_) {
    grid.insert(scan);
    plain.insert(scan);
  }
  EXPECT_EQ(plain.cells().size(), followed.size());
  EXPECT_EQ(grid.check().value_or(""), "");
  for (const auto& [cell, value] : plain.cells()) {
    ASSERT_EQ(grid.cell_value(cell), value) << cell.transpose();
  }
}

// All beams at 0.1 m: followed one by one, and cast inversely with every set of vector
// instructions.
TEST_P(RealScans, InverseCastingEqualsTheForwardWalk) {
  Random random(73);
  SCOPED_TRACE(random.trace());
  Grid forward({.resolution = 0.1, .traversal = Traversal::forward});
  InsertReport expected;
  for (const Scan& scan : scans_) expected += forward.insert(scan);
  EXPECT_GT(expected.misses, 200u);
  int threads = 1;
  test::for_each_simd_target([&](const char* target) {
    SCOPED_TRACE(target);
    Grid inverse({.resolution = 0.1, .traversal = Traversal::inverse, .threads = threads++});
    InsertReport report;
    for (const Scan& scan : scans_) report += inverse.insert(test::shuffled(scan, random));
    EXPECT_EQ(report, expected);
    EXPECT_TRUE(same_map(inverse, forward));
  });
  EXPECT_GT(threads, 1);
}

}  // namespace
}  // namespace rmap
