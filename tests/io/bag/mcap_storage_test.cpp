#include "io/bag/mcap_storage.hpp"

#include "io/bag/bag_samples.hpp"
#include "io/files.hpp"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

namespace rmap {
namespace {

using test::expect_error;
using test::McapStyle;
using test::scans_of;
using test::TestCompression;
using test::write_text;

const std::vector<test::ReadScan> kFive = {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}};

TEST(McapStorage, reads_every_style) {
  const test::TemporaryFolder folder;
  int cases = 0;
  for (const std::size_t step : {0, 1, 4, 1000}) {
    for (const auto compression :
         {TestCompression::none, TestCompression::lz4, TestCompression::zstd}) {
      for (const bool summary : {false, true}) {
        for (const bool checksums : {false, true}) {
          write_text(folder / "a.mcap",
                     test::mcap_bytes(test::driving_bag(5), {.messages_per_chunk = step,
                                                             .compression = compression,
                                                             .summary = summary,
                                                             .checksums = checksums}));
          EXPECT_EQ(scans_of(folder / "a.mcap"), kFive) << step;
          ++cases;
        }
      }
    }
  }
  EXPECT_EQ(cases, 48);
}

TEST(McapStorage, gives_scans_in_the_order_of_recording) {
  const test::TemporaryFolder folder;
  test::TestBag bag = test::driving_bag(5);
  std::reverse(bag.messages.begin(), bag.messages.end());
  for (const auto compression : {TestCompression::none, TestCompression::zstd}) {
    write_text(folder / "a.mcap",
               test::mcap_bytes(bag, {.messages_per_chunk = 3, .compression = compression}));
    EXPECT_EQ(scans_of(folder / "a.mcap"), kFive);
  }
}

TEST(McapStorage, recovers_what_is_complete_of_a_file_that_is_cut_off) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.mcap";
  for (const auto compression : {TestCompression::none, TestCompression::zstd}) {
    for (const std::size_t step : {0, 1000}) {
      const std::string bytes = test::mcap_bytes(
          test::driving_bag(5), {.messages_per_chunk = step, .compression = compression});
      // Behind the last but one cloud and before the last.
      const auto cut = bytes.rfind("base", bytes.rfind("lidar"));
      if (cut == std::string::npos) continue;
      write_text(file, bytes.substr(0, cut));
      if (compression == TestCompression::zstd && step != 0) continue;
      const auto source = open_scans(file);
      EXPECT_EQ(source->size(), 4u);
      ASSERT_EQ(source->notes().warnings.size(), 1u);
      EXPECT_NE(source->notes().warnings[0].find(file + " is cut off: 14 messages were recovered"),
                std::string::npos)
          << source->notes().warnings[0];
    }
  }
}

TEST(McapStorage, says_where_a_chunk_is_damaged) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.mcap";
  std::string bytes = test::mcap_bytes(test::driving_bag(5), {.messages_per_chunk = 1000});
  const auto place = bytes.rfind("lidar", bytes.rfind('\x0f'));
  bytes[place] = 'L';
  write_text(file, bytes);
  try {
    open_scans(file);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("is damaged"), std::string::npos) << error.what();
  }
  // A file that was not closed has the chunk's checksum alone.
  write_text(file, bytes.substr(0, bytes.size() - 8));
  try {
    open_scans(file);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("the checksum of a chunk is"), std::string::npos)
        << error.what();
  }
}

TEST(McapStorage, refuses_other_files) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.mcap";
  write_text(file, "text");
  expect_error(ErrorKind::input,
               file +
                   " is no bag: it begins with \"text\", where files of MCAP begin with "
                   "\"\\x89MCAP0\\x0d\\x0a\" and those of SQLite with \"SQLite format 3\\x00\"",
               [&] { open_scans(file); });
  write_text(file, "\x89MCAP0\r\n");
  expect_error(ErrorKind::input,
               file + " is damaged at byte 8: an MCAP file begins with a header, and there is none",
               [&] { open_scans(file); });
}

// Not a test: what scripts/check-bags has other implementations read.
TEST(McapStorage, DISABLED_write_samples) {
  const char* folder = std::getenv("RMAP_BAG_SAMPLES");
  ASSERT_NE(folder, nullptr) << "RMAP_BAG_SAMPLES must name a folder";
  const std::filesystem::path target = folder;
  const test::TestBag bag = test::driving_bag(5);
  const auto write = [&](const char* name, const McapStyle& style) {
    write_text(target / name, test::mcap_bytes(bag, style));
  };
  write("plain.mcap", {.messages_per_chunk = 0});
  write("none.mcap", {});
  write("lz4.mcap", {.compression = TestCompression::lz4});
  write("zstd.mcap", {.compression = TestCompression::zstd});
  write("bare.mcap", {.summary = false, .checksums = false});
  std::filesystem::remove(target / "lone.db3");
  test::write_db3(bag, target / "lone.db3");
}

}  // namespace
}  // namespace rmap
