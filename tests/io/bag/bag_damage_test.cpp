// Every cut and every changed byte of small bags: an error that names the file, or a warning, or
// a reading that the format cannot tell from a sound one; never anything else.
#include "io/bag/bag_samples.hpp"
#include "io/files.hpp"

#include <gtest/gtest.h>

#include <rmap/bag_info.hpp>

namespace rmap {
namespace {

using test::McapStyle;
using test::TestCompression;

enum class Outcome { sound, warned, refused };

// Reads all scans of the file.
Outcome outcome(const std::filesystem::path& file) {
  try {
    const auto source = open_scans(file);
    Scan scan;
    while (source->next(scan)) {
      EXPECT_LE(scan.points.size(), 1u);
    }
    return source->notes().warnings.empty() ? Outcome::sound : Outcome::warned;
  } catch (const Error& error) {
    EXPECT_NE(std::string_view(error.what()).find(file.string()), std::string_view::npos)
        << error.what();
    return Outcome::refused;
  }
}

std::vector<McapStyle> styles() {
  return {{.messages_per_chunk = 0},
          {.messages_per_chunk = 3},
          {.messages_per_chunk = 3, .compression = TestCompression::lz4},
          {.messages_per_chunk = 3, .compression = TestCompression::zstd, .summary = false}};
}

TEST(BagDamage, cuts_are_errors_or_warnings) {
  const test::TemporaryFolder folder;
  std::size_t warned = 0;
  for (const McapStyle& style : styles()) {
    const std::string bytes = test::mcap_bytes(test::driving_bag(2), style);
    test::write_text(folder / "a.mcap", bytes);
    EXPECT_EQ(outcome(folder / "a.mcap"), Outcome::sound);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
      test::write_text(folder / "a.mcap", bytes.substr(0, size));
      const Outcome result = outcome(folder / "a.mcap");
      EXPECT_NE(result, Outcome::sound) << size;
      warned += result == Outcome::warned ? 1 : 0;
    }
  }
  EXPECT_GT(warned, 1000u);
}

// The checksums of the messages and the summary cover all but themselves and the magic.
TEST(BagDamage, changed_bytes_are_noticed) {
  const test::TemporaryFolder folder;
  std::size_t cases = 0;
  for (const McapStyle& style : styles()) {
    const std::string bytes = test::mcap_bytes(test::driving_bag(2), style);
    for (std::size_t place = 0; place < bytes.size(); ++place, ++cases) {
      std::string changed = bytes;
      changed[place] = static_cast<char>(changed[place] ^ (1 << (place % 8)));
      test::write_text(folder / "a.mcap", changed);
      EXPECT_NE(outcome(folder / "a.mcap"), Outcome::sound) << place << " of " << bytes.size();
    }
  }
  EXPECT_GT(cases, 4000u);
}

TEST(BagDamage, changed_bytes_do_no_harm_without_checksums) {
  const test::TemporaryFolder folder;
  for (McapStyle style : styles()) {
    style.checksums = false;
    const std::string bytes = test::mcap_bytes(test::driving_bag(2), style);
    for (std::size_t place = 0; place < bytes.size(); ++place) {
      for (const int change : {1, 0x80, 0xff}) {
        std::string changed = bytes;
        changed[place] = static_cast<char>(changed[place] ^ change);
        test::write_text(folder / "a.mcap", changed);
        outcome(folder / "a.mcap");
      }
    }
  }
}

TEST(BagDamage, databases_do_no_harm) {
  const test::TemporaryFolder folder;
  test::write_db3(test::driving_bag(2), folder / "sound.db3");
  const std::string bytes = test::read_text(folder / "sound.db3");
  EXPECT_EQ(outcome(folder / "sound.db3"), Outcome::sound);
  std::size_t refused = 0;
  for (std::size_t place = 0; place < bytes.size(); place += 7) {
    std::string changed = bytes;
    changed[place] = static_cast<char>(changed[place] ^ 0x55);
    test::write_text(folder / "a.db3", changed);
    refused += outcome(folder / "a.db3") == Outcome::refused ? 1 : 0;
  }
  EXPECT_GT(refused, 20u);
  for (std::size_t size = 0; size < bytes.size(); size += 101) {
    test::write_text(folder / "a.db3", bytes.substr(0, size));
    EXPECT_EQ(outcome(folder / "a.db3"), Outcome::refused) << size;
  }
}

}  // namespace
}  // namespace rmap
