// Files of OctoMap that come from somebody who means harm: an error each, at once.
#include "io/files.hpp"
#include "io/octomap_samples.hpp"

#include <limits>

#include <gtest/gtest.h>

#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::octomap_header;
using test::octomap_refusal;
using test::value_file;
using test::value_node;
using test::values_to_zero;

constexpr std::uint64_t kHuge = std::uint64_t{1} << 63;

TEST(OctomapHostile, EveryTruncationIsRefused) {
  const std::string content = value_file({0.5F, -0.5F, 1.0F, 2.0F});
  ASSERT_EQ(test::imported(content).grid.cell_count(), 3u);
  for (std::size_t length = 0; length < content.size(); ++length) {
    ASSERT_EQ(octomap_refusal(content.substr(0, length)), ErrorKind::input) << length;
  }
  EXPECT_EQ(octomap_refusal(content + '\0'), ErrorKind::input);
  EXPECT_GT(content.size(), 150u);
}

TEST(OctomapHostile, SizesAreNotBelieved) {
  const std::string nodes = values_to_zero(16) + value_node(1.0F);
  int cases = 0;
  for (const bool states_only : {false, true}) {
    for (const std::uint64_t size : {kHuge, std::numeric_limits<std::uint64_t>::max(),
                                     std::uint64_t{16}, std::uint64_t{18}, std::uint64_t{0}}) {
      SCOPED_TRACE(size);
      EXPECT_EQ(octomap_refusal(octomap_header(size, states_only) + nodes), ErrorKind::input);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 10);
}

TEST(OctomapHostile, MegabytesOfOnesAreRefused) {
  const std::string ones(5'000'000, '\xff');
  for (const bool states_only : {false, true}) {
    for (const std::uint64_t size : {std::uint64_t{1'000'000}, kHuge}) {
      EXPECT_EQ(octomap_refusal(octomap_header(size, states_only) + ones), ErrorKind::input);
    }
  }
  // A header that does not end.
  EXPECT_EQ(octomap_refusal("# Octomap OcTree file\n" + ones), ErrorKind::input);
}

TEST(OctomapHostile, NodesBelowTheLastLevelAreRefused) {
  EXPECT_EQ(octomap_refusal(octomap_header(18, false) + values_to_zero(17) + value_node(1.0F)),
            ErrorKind::input);
  // As deep as the file is long.
  EXPECT_EQ(octomap_refusal(octomap_header(1'000'000, false) + values_to_zero(1'000'000)),
            ErrorKind::input);
}

TEST(OctomapHostile, OneLeafOfAllSpaceIsTooLarge) {
  EXPECT_EQ(octomap_refusal(octomap_header(1, false) + value_node(1.0F)), ErrorKind::limit);
  // An eighth of it, 2^45 cells, in either form.
  EXPECT_EQ(octomap_refusal(octomap_header(2, false) + value_node(1.0F, 1) + value_node(1.0F)),
            ErrorKind::limit);
  EXPECT_EQ(octomap_refusal(octomap_header(2, true) + test::raw<std::uint16_t>(2)),
            ErrorKind::limit);
  // Each fits, all together do not: they are counted before the first one is expanded.
  std::string nodes = values_to_zero(7) + value_node(1.0F, 0xff);
  for (int i = 0; i < 8; ++i) nodes += value_node(1.0F);
  EXPECT_EQ(octomap_refusal(octomap_header(16, false) + nodes), ErrorKind::limit);
}

TEST(OctomapHostile, ValuesThatAreNoNumbersAreRefused) {
  EXPECT_EQ(octomap_refusal(value_file({1.0F, std::numeric_limits<float>::quiet_NaN()})),
            ErrorKind::input);
}

TEST(OctomapHostile, InnerNodesWithoutChildrenAreRefused) {
  EXPECT_EQ(octomap_refusal(octomap_header(2, true) + test::raw<std::uint16_t>(3) +
                            test::raw<std::uint16_t>(0)),
            ErrorKind::input);
}

TEST(OctomapHostile, TreesOfAnotherLayoutAreRefused) {
  const std::string nodes = values_to_zero(16) + value_node(1.0F);
  for (const std::string id : {"CountingOcTree", "OcTreeX", "octree", "", "2"}) {
    EXPECT_EQ(octomap_refusal(octomap_header(17, false, "0.25", id) + nodes), ErrorKind::input);
  }
  for (const std::string id : {"OcTree", "OcTreeStamped", "1"}) {
    EXPECT_EQ(test::imported(octomap_header(17, false, "0.25", id) + nodes).grid.cell_count(), 1u);
  }
}

TEST(OctomapHostile, MessagesAreTextWhateverTheFileHolds) {
  const test::TemporaryFolder folder;
  const auto file = folder / "map.ot";
  test::write_text(file, octomap_header(0, false, "0.25", "a\xd1\x1b[2J" + std::string(900, 'b')));
  try {
    read_octomap_info(file);
    FAIL() << "it was taken";
  } catch (const Error& error) {
    const std::string sentence = error.what();
    EXPECT_NE(sentence.find("it holds a tree of type \"a\\xd1\\x1b[2Jbbb"), std::string::npos)
        << sentence;
    EXPECT_LT(sentence.size(), file.string().size() + 200);
  }
}

// Never more than an error that names the file, or a map.
TEST(OctomapHostile, FlippedBitsDoNoHarm) {
  const test::TemporaryFolder folder;
  const auto file = folder / "map.ot";
  const std::string content = value_file({0.5F, -0.5F, 1.0F, 2.0F});
  std::size_t cases = 0;
  std::size_t errors = 0;
  for (std::size_t bit = 0; bit < 8 * content.size(); ++bit, ++cases) {
    std::string bytes = content;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
    test::write_text(file, bytes);
    try {
      EXPECT_LE(import_octomap(file, {.max_cells = 1000, .keep_free = true}).grid.cell_count(),
                1000u);
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(file.string()), std::string::npos);
      ++errors;
    }
  }
  EXPECT_EQ(cases, 8 * content.size());
  EXPECT_GT(errors, 500u);
}

}  // namespace
}  // namespace rmap
