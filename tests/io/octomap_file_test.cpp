#include "io/files.hpp"

#include <algorithm>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include <rmap/octomap_file.hpp>

#ifdef RMAP_HAS_OCTOMAP
#include "support/octomap_twin.hpp"
#include "support/random.hpp"
#endif

namespace rmap {
namespace {

using test::TemporaryFolder;

enum Child : std::uint16_t { unknown = 0, empty = 1, occupied = 2, inner = 3 };

std::uint16_t node(std::initializer_list<std::pair<int, Child>> children) {
  unsigned states = 0;
  for (const auto& [child, state] : children) states |= unsigned{state} << (2 * child);
  return static_cast<std::uint16_t>(states);
}

std::string header(std::uint64_t nodes, const std::string& resolution = "0.25") {
  return "# Octomap OcTree binary file\n# (a comment)\n#\nid OcTree\nsize " +
         std::to_string(nodes) + "\nres " + resolution + "\ndata\n";
}

std::string bytes(const std::vector<std::uint16_t>& nodes) {
  std::string text;
  for (const std::uint16_t states : nodes) text += test::raw(states);
  return text;
}

/// A tree whose nodes lead to the lowest cell above 0 on all axes; the last ones are `last`.
std::vector<std::uint16_t> path_to_zero(std::size_t levels, std::uint16_t last) {
  std::vector<std::uint16_t> nodes(levels, node({{0, inner}}));
  if (levels > 0) nodes.front() = node({{7, inner}});
  nodes.push_back(last);
  return nodes;
}

OctomapCells read(const std::string& content, const OctomapReadOptions& options = {}) {
  const TemporaryFolder folder;
  test::write_text(folder / "map.bt", content);
  return read_octomap(folder / "map.bt", options);
}

ErrorKind kind_of_refusal(const std::string& content, const OctomapReadOptions& options = {}) {
  try {
    read(content, options);
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("map.bt"), std::string::npos) << error.what();
    return error.kind();
  }
  ADD_FAILURE() << "it was taken";
  return ErrorKind::usage;
}

// Two cells and a free one at the end of 15 inner nodes.
std::string tiny_map() {
  const auto nodes = path_to_zero(15, node({{0, occupied}, {3, empty}, {6, occupied}}));
  return header(nodes.size() + 3) + bytes(nodes);
}

TEST(OctomapFile, CellsAreKeysLess32768) {
  const OctomapCells map = read(tiny_map());
  EXPECT_EQ(map.resolution, 0.25);
  EXPECT_EQ(map.occupied, (std::vector<Cell>{{0, 0, 0}, {0, 1, 1}}));
  EXPECT_EQ(map.occupied_leaves, 2u);
  EXPECT_EQ(map.free_leaves, 1u);
}

TEST(OctomapFile, AnEmptyTreeHasNoCells) {
  EXPECT_TRUE(read(header(0)).occupied.empty());
  EXPECT_TRUE(read(header(1) + bytes({0})).occupied.empty());
}

TEST(OctomapFile, LargeLeavesAreExpandedUpToALimit) {
  const auto nodes = path_to_zero(12, node({{0, occupied}, {1, empty}}));  // 8 cells each way
  const std::string content = header(nodes.size() + 2) + bytes(nodes);
  const OctomapCells map = read(content, {.max_cells = 512});
  EXPECT_EQ(map.occupied_leaves, 1u);
  ASSERT_EQ(map.occupied.size(), 512u);
  std::set<std::tuple<int, int, int>> cells;
  for (const Cell& cell : map.occupied) {
    EXPECT_TRUE((CellBox{.min = Cell::Zero(), .max = Cell::Constant(8)}.contains(cell)));
    cells.insert({cell.x(), cell.y(), cell.z()});
  }
  EXPECT_EQ(cells.size(), 512u);
  EXPECT_EQ(kind_of_refusal(content, {.max_cells = 511}), ErrorKind::limit);
  EXPECT_EQ(kind_of_refusal(content, {.max_cells = 0}), ErrorKind::limit);
  // A leaf of an eighth of all space.
  const std::string huge = header(2) + bytes({node({{2, occupied}})});
  EXPECT_EQ(kind_of_refusal(huge), ErrorKind::limit);
  // Many leaves that fit one by one but not together.
  const auto many = path_to_zero(12, node({{0, occupied}, {1, occupied}}));
  EXPECT_EQ(kind_of_refusal(header(many.size() + 2) + bytes(many), {.max_cells = 1000}),
            ErrorKind::limit);
}

TEST(OctomapFile, EveryTruncationIsRefused) {
  const std::string content = tiny_map();
  int refused = 0;
  for (std::size_t length = 0; length < content.size(); ++length, ++refused) {
    SCOPED_TRACE(length);
    ASSERT_EQ(kind_of_refusal(content.substr(0, length)), ErrorKind::input);
  }
  EXPECT_EQ(refused, static_cast<int>(content.size()));
  EXPECT_EQ(kind_of_refusal(content + '\0'), ErrorKind::input);
}

TEST(OctomapFile, WrongHeadersAreRefused) {
  const std::string nodes = tiny_map().substr(header(19).size());
  ASSERT_EQ(read(header(19) + nodes).occupied.size(), 2u);
  const auto without = [&](const std::string& line) {
    std::string text = header(19);
    return text.erase(text.find(line), line.size()) + nodes;
  };
  const auto with = [&](const std::string& line, const std::string& instead) {
    std::string text = header(19);
    return text.replace(text.find(line), line.size(), instead) + nodes;
  };
  int refused = 0;
  for (const std::string& content : {without("# Octomap OcTree binary file\n"),
                                     without("id OcTree\n"),
                                     without("size 19\n"),
                                     without("res 0.25\n"),
                                     without("data\n"),
                                     with("OcTree b", "OcTree "),
                                     with("id OcTree", "id CountingOcTree"),
                                     with("size 19", "size 18"),
                                     with("size 19", "size 20"),
                                     with("size 19", "size -1"),
                                     with("size 19", "size many"),
                                     with("size 19", "size 19x"),
                                     with("size 19", "size"),
                                     with("size 19", "size 0"),
                                     with("res 0.25", "res 0"),
                                     with("res 0.25", "res -1"),
                                     with("res 0.25", "res nan"),
                                     with("res 0.25", "res inf"),
                                     with("res 0.25", "res 0,25"),
                                     with("(a comment)", std::string(5000, 'x')),
                                     std::string(),
                                     std::string("PCD")}) {
    SCOPED_TRACE(content.substr(0, 200));
    EXPECT_EQ(kind_of_refusal(content), ErrorKind::input);
    ++refused;
  }
  EXPECT_EQ(refused, 22);
  // Lines of no meaning, and those of another system, are none of the errors.
  EXPECT_EQ(read(with("id OcTree", "id OcTree\r\nversion 3\n")).occupied.size(), 2u);
  EXPECT_EQ(read(with("id OcTree", "id \t OcTree \n")).occupied.size(), 2u);
}

TEST(OctomapFile, NodesBelowTheDepthAreRefused) {
  const auto nodes = path_to_zero(16, node({{0, occupied}}));
  EXPECT_EQ(kind_of_refusal(header(nodes.size() + 1) + bytes(nodes)), ErrorKind::input);
}

TEST(OctomapFile, AMissingFileIsAnErrorOfTheSystem) {
  try {
    read_octomap("/nowhere/map.bt");
    FAIL() << "it was taken";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::io);
  }
}

#ifdef RMAP_HAS_OCTOMAP

std::vector<Cell> sorted(std::vector<Cell> cells) {
  std::sort(cells.begin(), cells.end(), morton_less);
  return cells;
}

void expect_as_octomap(const std::filesystem::path& file, octomap::OcTree& tree) {
  const OctomapCells map = read_octomap(file);
  EXPECT_DOUBLE_EQ(map.resolution, tree.getResolution());
  const auto theirs = test::occupied_cells(tree);
  EXPECT_EQ(sorted(map.occupied), std::vector<Cell>(theirs.begin(), theirs.end()));
}

TEST(OctomapFile, WrittenByOctomapIsReadAlike) {
  const TemporaryFolder folder;
  int compared = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed, ++compared) {
    test::Random random(seed);
    SCOPED_TRACE(random.trace());
    octomap::OcTree tree(0.2);
    const auto update = [&](const Cell& cell, bool hit) {
      octomap::OcTreeKey key;
      for (unsigned axis = 0; axis < 3; ++axis) {
        key[axis] = static_cast<octomap::key_type>(cell[static_cast<int>(axis)] + 32768);
      }
      tree.updateNode(key, hit);
    };
    for (int i = 0; i < 800; ++i) update(random.cell(-20, 20), random.chance(0.6));
    for (int i = 0; i < 512; ++i) update({8 + i % 8, -8 + i / 8 % 8, i / 64}, true);  // pruned
    update(Cell::Constant(-32768), true);
    update(Cell::Constant(32767), true);
    tree.toMaxLikelihood();
    tree.prune();
    const auto file = folder / "map.bt";
    ASSERT_TRUE(tree.writeBinary(file.string()));
    expect_as_octomap(file, tree);
  }
  EXPECT_EQ(compared, 10);
}

TEST(OctomapFile, RealMapsAreReadAsOctomapReadsThem) {
  const auto maps = test::real_data("maps");
  if (maps.empty()) GTEST_SKIP() << "the maps are not there: set RMAP_DATA";
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(maps)) {
    if (entry.path().extension() != ".bt") continue;
    SCOPED_TRACE(entry.path().filename().string());
    octomap::OcTree tree(entry.path().string());
    expect_as_octomap(entry.path(), tree);
    ++compared;
  }
  EXPECT_GE(compared, 1);
}

#endif

}  // namespace
}  // namespace rmap
