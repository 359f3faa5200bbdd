// Against liboctomap, where it is there: its files are read as it reads them, and ours it reads
// as we do, and writes back byte for byte.
#include "io/files.hpp"
#include "support/octomap_leaves.hpp"
#include "support/random.hpp"

#include <memory>
#include <sstream>

#include <gtest/gtest.h>

namespace rmap {
namespace {

class OctomapOracle : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }

  /// What liboctomap makes of a `.ot`.
  static std::unique_ptr<octomap::OcTree> read_values(const std::filesystem::path& file) {
    return std::unique_ptr<octomap::OcTree>(
        dynamic_cast<octomap::OcTree*>(octomap::AbstractOcTree::read(file.string())));
  }

  static std::string bytes_of_values(const octomap::OcTree& tree) {
    std::ostringstream out;
    tree.write(out);
    return out.str();
  }
  static std::string bytes_of_states(octomap::OcTree& tree) {
    std::ostringstream out;
    tree.writeBinary(out);
    return out.str();
  }

  /// Our files of a grid, read by liboctomap.
  void expect_octomap_reads(const Grid& grid) const {
    const OctomapExport values = export_octomap(grid, file("ours.ot"));
    const auto tree = read_values(file("ours.ot"));
    ASSERT_TRUE(tree);
    EXPECT_EQ(tree->size(), values.nodes);
    test::expect_same_leaves(grid, *tree);
    // Inner nodes and pruning as its own: it leaves every byte as it is.
    tree->updateInnerOccupancy();
    tree->prune();
    EXPECT_EQ(bytes_of_values(*tree), test::read_text(file("ours.ot")));

    const OctomapExport states = export_octomap(grid, file("ours.bt"));
    octomap::OcTree binary(grid.lattice().resolution());
    ASSERT_TRUE(binary.readBinary(file("ours.bt").string()));
    EXPECT_EQ(binary.size(), states.nodes);
    EXPECT_EQ(bytes_of_states(binary), test::read_text(file("ours.bt")));
    EXPECT_EQ(bytes_of_states(*tree), test::read_text(file("ours.bt")));
  }

  const test::TemporaryFolder folder_;
};

octomap::OcTreeKey key_of(const Cell& cell) {
  octomap::OcTreeKey key;
  for (unsigned axis = 0; axis < 3; ++axis) {
    key[axis] = static_cast<octomap::key_type>(cell[static_cast<int>(axis)] + 32768);
  }
  return key;
}

TEST_F(OctomapOracle, RandomTreesAreReadAlike) {
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed, ++compared) {
    test::Random random(seed);
    SCOPED_TRACE(random.trace());
    octomap::OcTree tree(0.2);
    for (int i = 0; i < 3000; ++i)
      tree.updateNode(key_of(random.cell(-12, 12)), random.chance(0.6));
    for (int i = 0; i < 512; ++i) {  // a cube that is pruned
      for (int hits = 0; hits < 6; ++hits) {
        tree.updateNode(key_of({16 + i % 8, -8 + i / 8 % 8, i / 64}), true);
      }
    }
    for (const int corner : {-32768, 32767}) tree.updateNode(key_of(Cell::Constant(corner)), true);
    // Values around OctoMap's threshold, which are occupied from 0 on.
    for (int i = -8; i < 8; ++i) {
      tree.setNodeValue(key_of({i, 100, 0}), static_cast<float>(i) * 0.0003F);
    }
    tree.updateInnerOccupancy();
    tree.prune();
    ASSERT_TRUE(tree.write(file("theirs.ot").string()));
    const OctomapImport map = import_octomap(file("theirs.ot"), {.keep_free = true});
    EXPECT_EQ(map.grid.cell_count(), test::cell_count_of(tree));
    EXPECT_EQ(map.file.nodes, tree.size());
    EXPECT_EQ(map.file.occupied_leaves + map.file.free_leaves, tree.getNumLeafNodes());
    EXPECT_EQ(map.changed_leaves + map.clamped_leaves, 0u);
    test::expect_same_leaves(map.grid, tree);
    expect_octomap_reads(map.grid);
    const auto occupied = import_octomap(file("theirs.ot")).grid.cell_count();
    EXPECT_EQ(occupied, test::occupied_cells(tree).size());
  }
  EXPECT_EQ(compared, 10);
}

TEST_F(OctomapOracle, RealMapsOfStatesThereAndBack) {
  const auto maps = test::real_data("maps");
  if (maps.empty()) GTEST_SKIP() << "the maps are not there: set RMAP_DATA";
  int compared = 0;
  for (const char* name : {"geb079.bt", "fr_079.bt", "fr_campus.bt"}) {
    SCOPED_TRACE(name);
    octomap::OcTree tree(1);
    ASSERT_TRUE(tree.readBinary((maps / name).string()));
    const OctomapInfo info = read_octomap_info(maps / name);
    EXPECT_EQ(info.nodes, tree.size());
    EXPECT_EQ(info.occupied_leaves + info.free_leaves, tree.getNumLeafNodes());
    const OctomapImport map = import_octomap(maps / name);
    EXPECT_EQ(map.grid.cell_count(), info.occupied_cells);
    EXPECT_EQ(map.dropped_free_leaves, info.free_leaves);
    // Again as a file of OctoMap, now without what is free.
    const OctomapExport ours = export_octomap(map.grid, file(name));
    octomap::OcTree again(1);
    ASSERT_TRUE(again.readBinary(file(name).string()));
    EXPECT_EQ(again.size(), ours.nodes);
    EXPECT_EQ(ours.lost_values, 0u);
    EXPECT_EQ(test::occupied_cells(again), test::occupied_cells(tree));
    ++compared;
  }
  EXPECT_EQ(compared, 3);
}

TEST_F(OctomapOracle, AMapWithFreeSpaceIsWrittenAsItWas) {
  const auto maps = test::real_data("maps");
  if (maps.empty()) GTEST_SKIP() << "the maps are not there: set RMAP_DATA";
  const OctomapImport map = import_octomap(maps / "geb079.bt", {.keep_free = true});
  expect_octomap_reads(map.grid);
  // liboctomap does not change it either: all states, and in its pruned form.
  octomap::OcTree tree((maps / "geb079.bt").string());
  EXPECT_EQ(bytes_of_states(tree), test::read_text(file("ours.bt")));
}

TEST_F(OctomapOracle, AMapWithColoursIsReadAlike) {
  const auto maps = test::real_data("maps");
  if (maps.empty()) GTEST_SKIP() << "the maps are not there: set RMAP_DATA";
  const auto name = (maps / "home_color.ot").string();
  const std::unique_ptr<octomap::ColorOcTree> tree(
      dynamic_cast<octomap::ColorOcTree*>(octomap::AbstractOcTree::read(name)));
  ASSERT_TRUE(tree);
  const OctomapImport map = import_octomap(name, {.keep_free = true});
  EXPECT_TRUE(map.file.colors);
  EXPECT_EQ(map.file.nodes, tree->size());
  EXPECT_EQ(map.clamped_leaves + map.changed_leaves, 0u);
  test::expect_same_leaves(map.grid, *tree);
  expect_octomap_reads(map.grid);
}

}  // namespace
}  // namespace rmap
