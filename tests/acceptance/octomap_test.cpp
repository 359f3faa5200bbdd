// Against liboctomap with the same float32 points and parameters: complete history
// gives its occupied cells, first-hit history those and a few more.
#include <gtest/gtest.h>

#include <rmap/grid.hpp>
#include <rmap/scan_source.hpp>

#include "support/grids.hpp"
#include "support/octomap_twin.hpp"
#include "support/real_data.hpp"

namespace rmap {
namespace {

class AgainstOctoMap : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Sequences, AgainstOctoMap, testing::ValuesIn(test::sequence_names()),
                         [](const auto& sequence) { return sequence.param; });

std::size_t missing_from(const std::set<Cell, test::MortonOrder>& cells, const Grid& grid) {
  std::size_t missing = 0;
  for (const Cell& cell : cells) missing += grid.cell_state(cell) == State::occupied ? 0 : 1;
  return missing;
}

std::size_t missing_from(const Grid& grid, const std::set<Cell, test::MortonOrder>& cells) {
  std::size_t missing = 0;
  for (const CellValue& entry : test::all_cell_values(grid)) {
    missing += grid.rule().occupied(entry.value) && !cells.contains(entry.cell) ? 1 : 0;
  }
  return missing;
}

TEST_P(AgainstOctoMap, OccupiedCellsAreTheSame) {
  const auto folder = test::sequence_folder(GetParam());
  if (folder.empty()) GTEST_SKIP() << "the sequence " << GetParam() << " is not there: set RMAP_DATA";
  const Options options{.resolution = 0.2};
  Grid complete(options);
  Grid first_hit(options);
  octomap::OcTree tree(options.resolution);
  std::size_t beams = 0;
  auto scans = read_scans(folder);
  for (const Scan& scan : scans) complete.prepare(test::in_map_frame(scan));
  scans.rewind();
  for (const Scan& scan : scans) {
    const Scan moved = test::in_map_frame(scan);
    complete.insert(moved);
    first_hit.insert(moved);
    test::insert_into(tree, moved);
    beams += moved.points.size();
  }
  const auto theirs = test::occupied_cells(tree);
  const auto allowed = 1 + beams * 10 / 1000000;  // cells whose borders OctoMap rounds in float
  ASSERT_GT(theirs.size(), 200u);
  EXPECT_LE(missing_from(theirs, complete) + missing_from(complete, theirs), allowed);
  EXPECT_LE(missing_from(theirs, first_hit), allowed);
  EXPECT_GE(missing_from(first_hit, theirs), missing_from(complete, theirs));
  RecordProperty("beams", static_cast<int>(beams));
  RecordProperty("occupied", static_cast<int>(theirs.size()));
  RecordProperty("more_with_first_hit", static_cast<int>(missing_from(first_hit, theirs)));
}

}  // namespace
}  // namespace rmap
