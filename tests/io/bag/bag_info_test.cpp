#include "io/bag/bag_samples.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/bag_info.hpp>

namespace rmap {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(BagInfo, tells_topics_frames_and_what_comes_of_the_clouds) {
  const test::TemporaryFolder folder;
  test::TestBag bag = test::driving_bag(3);
  test::add_cloud(bag, test::kStart + 10 * test::kSecond, 9, "/rear", "elsewhere");
  test::write_text(folder / "a.mcap",
                   test::mcap_bytes(bag, {.compression = test::TestCompression::lz4}));
  EXPECT_TRUE(is_bag(folder / "a.mcap"));
  EXPECT_FALSE(is_bag(folder.path()));
  const BagInfo info = read_bag_info(folder / "a.mcap");
  EXPECT_EQ(info.format, "mcap");
  EXPECT_EQ(info.files, 1u);
  EXPECT_THAT(info.compressions, ElementsAre("lz4"));
  EXPECT_EQ(info.messages, 11u);
  EXPECT_EQ(info.first, test::kStart);
  EXPECT_EQ(info.last, test::kStart + 10 * test::kSecond);
  ASSERT_EQ(info.topics.size(), 5u);
  EXPECT_EQ(info.topics[0].name, "/odom");
  EXPECT_EQ(info.topics[0].messages, 3u);
  EXPECT_THAT(info.topics[0].frames, ElementsAre("odom"));
  EXPECT_THAT(info.topics[0].child_frames, ElementsAre("base"));
  ASSERT_EQ(info.frames.size(), 2u);
  EXPECT_EQ(info.frames[0].name, "base");
  EXPECT_TRUE(info.frames[0].moves);
  EXPECT_EQ(info.frames[0].poses, 3u);
  EXPECT_FALSE(info.frames[1].moves);
  ASSERT_EQ(info.clouds.size(), 2u);
  EXPECT_EQ(info.clouds[0].scans, 3u);
  EXPECT_EQ(info.clouds[0].poses, "transforms from odom");
  EXPECT_EQ(info.clouds[0].problem, "");
  EXPECT_THAT(info.clouds[1].problem, HasSubstr("no transforms lead from it"));
  EXPECT_TRUE(info.warnings.empty());
}

TEST(BagInfo, of_nothing_is_nothing) {
  const test::TemporaryFolder folder;
  test::write_db3({}, folder / "a.db3");
  const BagInfo info = read_bag_info(folder / "a.db3");
  EXPECT_EQ(info.format, "sqlite3");
  EXPECT_EQ(info.messages, 0u);
  EXPECT_TRUE(info.topics.empty());
  EXPECT_TRUE(info.clouds.empty());
}

}  // namespace
}  // namespace rmap
