// Bags made to hurt: each is refused before it takes memory or time.
#include "io/bag/bag_samples.hpp"
#include "io/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/bag_info.hpp>

namespace rmap {
namespace {

using test::mcap_chunk;
using test::mcap_record;
using testing::HasSubstr;

const std::string kMagic = "\x89MCAP0\r\n";

std::string start() { return kMagic + mcap_record(1, std::string(8, '\0')); }

class HostileBag : public testing::Test {
 protected:
  std::string refusal(const std::string& bytes) {
    test::write_text(folder_ / "a.mcap", bytes);
    try {
      open_scans(folder_ / "a.mcap");
      return "no error";
    } catch (const Error& error) {
      return error.what();
    }
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(HostileBag, of_ones_is_no_bag) {
  const std::string ones(5'000'000, '\xff');
  EXPECT_THAT(refusal(kMagic + ones), HasSubstr("begins with a header, and there is none"));
  EXPECT_THAT(refusal(start() + ones), HasSubstr("5000000 bytes from byte 25 on hold nothing "
                                                 "complete and are lost"));
  EXPECT_THAT(refusal(start() + ones + kMagic), HasSubstr("there is no footer"));
}

TEST_F(HostileBag, with_records_of_2_to_the_63_is_refused) {
  const std::string huge = "\x05" + test::raw(std::uint64_t{1} << 63) + "abc";
  EXPECT_THAT(refusal(start() + huge), HasSubstr("there are no clouds"));
  const std::string sound = test::mcap_bytes({}, {.checksums = false});
  std::string closed = sound;
  closed.insert(start().size(), huge);
  EXPECT_THAT(refusal(closed), HasSubstr("is damaged"));
}

TEST_F(HostileBag, with_chunks_that_unpack_to_too_much_is_refused) {
  const std::string zeros(std::size_t{200} << 20, '\0');
  for (const auto compression : {test::TestCompression::zstd, test::TestCompression::lz4}) {
    const bool zstd = compression == test::TestCompression::zstd;
    const std::string packed = test::pack(compression, zeros);
    const std::string chunk = mcap_chunk(zstd ? "zstd" : "lz4", packed, zeros.size(), 0);
    EXPECT_THAT(refusal(start() + chunk),
                HasSubstr("100 times the packed size, which are allowed"));
    EXPECT_THAT(refusal(start() + mcap_chunk(zstd ? "zstd" : "lz4", packed.substr(0, 1000),
                                             std::uint64_t{1} << 63, 0)),
                HasSubstr("it says that it unpacks to 9223372036854775808 bytes"));
    EXPECT_THAT(
        refusal(start() + mcap_chunk(zstd ? "zstd" : "lz4", packed.substr(0, 1000), 1'000'000, 0)),
        HasSubstr("does not unpack to the 1000000 bytes that it announces"));
    EXPECT_THAT(refusal(start() +
                        mcap_chunk(zstd ? "zstd" : "lz4", packed.substr(0, 1000), 100'000'000, 0)),
                HasSubstr("which are allowed"));
  }
  EXPECT_THAT(refusal(start() + mcap_chunk("bz2", "abc", 3, 0)),
              HasSubstr("a chunk is compressed by \"bz2\", where lz4, zstd and none are allowed"));
  EXPECT_THAT(refusal(start() + mcap_chunk("", "abc", 7, 0)),
              HasSubstr("says that its 3 bytes unpack to 7"));
}

// Each chunk is small enough, but a thousand of them would take minutes.
TEST_F(HostileBag, with_many_small_bombs_is_refused) {
  // Records of a kind that nobody knows, without content.
  std::string records;
  for (int i = 0; i < 1'000'000; ++i) records += mcap_record(0x80, "");
  const std::string chunk =
      mcap_chunk("zstd", test::pack(test::TestCompression::zstd, records), records.size(), 0);
  std::string bytes = start();
  for (int i = 0; i < 1000; ++i) bytes += chunk;
  EXPECT_THAT(refusal(bytes), HasSubstr("which are allowed"));
}

TEST_F(HostileBag, with_channels_of_nowhere_is_refused) {
  EXPECT_THAT(refusal(start() + mcap_record(5, std::string(30, '\7'))),
              HasSubstr("a message is of channel 1799, which no record before it describes"));
  EXPECT_THAT(refusal(start() + mcap_record(5, "abc")),
              HasSubstr("a message has 3 bytes, and must have 22 at least"));
  EXPECT_THAT(
      refusal(start() + mcap_record(4, test::raw(std::uint16_t{1}) + test::raw(std::uint16_t{9}) +
                                           std::string(12, '\0'))),
      HasSubstr("has schema 9, which no record before it describes"));
}

TEST_F(HostileBag, with_clouds_of_impossible_sizes_is_refused) {
  for (int kind = 0; kind < 3; ++kind) {
    test::TestBag bag = test::driving_bag(1);
    test::TestCloud cloud;
    cloud.stamp = test::kStart;
    cloud.width = kind == 0 ? ~0U : 10'000'000;
    cloud.height = kind == 0 ? ~0U : 1;
    cloud.point_step = kind == 0 ? ~0U : 12;
    cloud.row_step = kind == 2 ? 120'000'000 : ~0U;
    bag.messages.back().data = cloud.message();
    const test::TemporaryFolder folder;
    test::write_text(folder / "a.mcap", test::mcap_bytes(bag));
    const auto source = open_scans(folder / "a.mcap");
    Scan scan;
    try {
      source->next(scan);
      FAIL();
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("a.mcap, message 1 of /points: its "));
    }
  }
}

TEST_F(HostileBag, with_messages_that_unpack_to_too_much_is_refused) {
  const std::string zeros(std::size_t{200} << 20, '\0');
  test::TestBag bag = test::driving_bag(1);
  bag.messages.back().data = test::pack(test::TestCompression::zstd, zeros);
  const test::TemporaryFolder folder;
  test::write_db3(bag, folder / "a.db3");
  const auto source = open_scans(folder / "a.db3");
  Scan scan;
  try {
    source->next(scan);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::limit);
    EXPECT_THAT(error.what(), HasSubstr("message 1 of /points: its "));
  }
}

}  // namespace
}  // namespace rmap
