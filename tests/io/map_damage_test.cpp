#include "io/files.hpp"
#include "io/map_samples.hpp"
#include "io/raw_map.hpp"

#include <gtest/gtest.h>

#include <rmap/map_file.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::raw;
using test::RawChunk;
using test::RawMap;

class MapDamage : public testing::Test {
 protected:
  MapDamage() { save(test::small_map(), file_); }

  // Whether both ways to read refuse these bytes by their content.
  bool refused(const std::string& bytes) {
    test::write_text(file_, bytes);
    ++files_;
    return input_error([&] { load(file_); }) && input_error([&] { read_map_info(file_); });
  }

  void expect_load_error(const std::string& bytes, const std::string& sentence) {
    test::write_text(file_, bytes);
    expect_error(ErrorKind::input, file_.string() + sentence, [&] { load(file_); });
    ++files_;
  }
  void expect_load_error(const RawMap& map, const std::string& sentence) {
    expect_load_error(bytes_of(map), sentence);
  }

  // Sound, and with nothing compressed: byte offsets of the chunks are 48, 168, 204, 428, 563.
  const RawMap plain_ = test::raw_map(test::small_map());
  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "a.rmap";
  std::size_t files_ = 0;

 private:
  template <class Call>
  static bool input_error(Call&& call) {
    try {
      call();
      return false;
    } catch (const Error& error) {
      return error.kind() == ErrorKind::input;
    }
  }
};

TEST_F(MapDamage, of_every_single_bit_is_noticed) {
  const std::string bytes = test::read_text(file_);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      std::string damaged = bytes;
      damaged[i] = static_cast<char>(damaged[i] ^ 1 << bit);
      ASSERT_TRUE(refused(damaged)) << "bit " << bit << " of byte " << i;
    }
  }
  EXPECT_EQ(files_, 8 * bytes.size());
  EXPECT_GT(bytes.size(), 400U);
}

TEST_F(MapDamage, by_every_cut_and_every_addition_is_noticed) {
  const std::string bytes = test::read_text(file_);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    ASSERT_TRUE(refused(bytes.substr(0, size))) << size;
  }
  for (int byte = 0; byte < 256; ++byte) {
    ASSERT_TRUE(refused(bytes + static_cast<char>(byte))) << byte;
  }
  ASSERT_TRUE(refused(bytes + bytes));
  EXPECT_EQ(files_, bytes.size() + 256 + 1);
}

TEST_F(MapDamage, by_chunks_left_out_repeated_or_exchanged_is_noticed) {
  const std::string bytes = test::read_text(file_);
  const RawMap map = test::parsed(bytes);
  std::vector<std::string> parts = {bytes.substr(0, 48)};
  for (std::size_t offset = 48; const RawChunk& chunk : map.chunks) {
    const std::size_t size = 24 + chunk.stored.size() + 8;
    parts.push_back(bytes.substr(offset, size));
    offset += size;
  }
  const auto joined = [](const std::vector<std::string>& pieces) {
    std::string whole;
    for (const std::string& piece : pieces) whole += piece;
    return whole;
  };
  ASSERT_EQ(joined(parts), bytes);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    std::vector<std::string> others = parts;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    EXPECT_TRUE(refused(joined(others))) << "without part " << i;
    others = parts;
    others[i] += parts[i];
    EXPECT_TRUE(refused(joined(others))) << "part " << i << " twice";
    for (std::size_t j = 1; j < i; ++j) {
      others = parts;
      std::swap(others[i], others[j]);
      EXPECT_TRUE(refused(joined(others))) << "parts " << i << " and " << j;
    }
  }
  EXPECT_EQ(files_, 5 + 5 + 10U);
}

TEST_F(MapDamage, by_a_chunk_of_another_map_is_noticed) {
  Grid other = test::small_map();
  other.set_value({0, 0, 0}, 101);
  const std::string bytes = bytes_of(plain_);
  const std::string other_bytes = bytes_of(test::raw_map(other));
  ASSERT_EQ(bytes.size(), other_bytes.size());
  ASSERT_NE(bytes, other_bytes);
  std::size_t cases = 0;
  for (std::size_t offset = 48; const RawChunk& chunk : plain_.chunks) {
    const std::size_t size = 24 + chunk.stored.size() + 8;
    std::string mixed = bytes;
    mixed.replace(offset, size, other_bytes, offset, size);
    if (mixed != bytes && mixed != other_bytes) {
      EXPECT_TRUE(refused(mixed)) << offset;
      ++cases;
    }
    offset += size;
  }
  EXPECT_EQ(cases, 2U);  // CELL and END: what comes before them is the same in both
}

TEST_F(MapDamage, is_told_from_files_of_another_kind) {
  const std::string other =
      " is not an rmap file: its first 8 bytes are not those that every "
      "rmap file begins with";
  for (const std::string bytes : {"", "\x89", "\x89RMA", "RMAP\r\n\n", "ply\nformat ascii 1.0\n"}) {
    expect_load_error(bytes, other);
  }
  expect_load_error("\x89RMAP\r\n\n",
                    " is cut off: it has 8 bytes, and the header of an rmap file alone takes 48");
  for (const std::string start : {"\x89RMAP\n\n", "\x89RMAP\r\r\n", "\x89RMAP\r\n\r\n"}) {
    expect_load_error(start + bytes_of(plain_).substr(8),
                      " is a damaged rmap file: bytes 5 to 7 are not what they must be, as when a "
                      "transfer in text mode rewrites the ends of lines");
  }
  EXPECT_EQ(files_, 9U);
  EXPECT_THROW(load(folder_.path()), Error);
  EXPECT_THROW(load(folder_ / "missing.rmap"), Error);
}

TEST_F(MapDamage, is_told_with_its_place) {
  std::string bytes = bytes_of(plain_);
  bytes[20] ^= 1;
  expect_load_error(bytes, " is damaged: the checksum of the header does not fit its bytes");
  bytes = bytes_of(plain_);
  bytes[48 + 24] ^= 1;
  expect_load_error(bytes,
                    " is damaged: the checksum of chunk OPTS at byte 48 does not fit its bytes");
  expect_load_error(bytes_of(plain_).substr(0, 180),
                    " is cut off: at byte 168 a chunk must follow, up to the END chunk, and 12 "
                    "bytes are left");
  expect_load_error(bytes_of(plain_).substr(0, 195),
                    " is cut off or damaged: chunk HIST at byte 168 takes 4 bytes and a checksum, "
                    "and 3 bytes are left");
  const std::size_t size = bytes.size();
  expect_load_error(bytes_of(plain_) + "x",
                    " goes on for 1 bytes behind its END chunk, which ends "
                    "at byte " +
                        std::to_string(size));
}

TEST_F(MapDamage, leaves_out_unknown_chunks_that_are_optional) {
  std::size_t cases = 0;
  for (std::size_t place = 0; place < plain_.chunks.size(); ++place) {
    for (const RawChunk& extra :
         {RawChunk{.type = "OBSV", .stored = "abc", .raw_size = 3, .flags = 0},
          RawChunk{.type = "CUBO", .stored = "", .raw_size = 0, .flags = 0, .version = 2},
          RawChunk{.type = "CELL", .stored = "abc", .raw_size = 3, .flags = 0, .version = 2},
          RawChunk{.type = {'\0', '\xff', ' ', 'a'},
          .stored = std::string(200000, 'x'),
          .raw_size = std::uint64_t{1} << 60,
          .flags = 0xfffe}}) {
      RawMap map = plain_;
      map.chunks.insert(map.chunks.begin() + static_cast<std::ptrdiff_t>(place), extra);
      map.chunks.back().stored = raw<std::uint64_t>(map.chunks.size() - 1);
      const std::string bytes = bytes_of(map);
      test::write_text(file_, bytes);
      EXPECT_TRUE(same_map(load(file_), test::small_map()));
      EXPECT_EQ(read_map_info(file_).chunks.size(), map.chunks.size());
      ++cases;

      std::string damaged = bytes;
      damaged[48 + 24 + 2 + 8] ^= 1;
      EXPECT_TRUE(refused(damaged));
    }
  }
  EXPECT_EQ(cases, 20U);
  EXPECT_EQ(files_, 20U);
}

TEST_F(MapDamage, is_not_what_a_newer_release_writes) {
  RawMap map = plain_;
  map.chunks.insert(map.chunks.begin(),
                    {.type = "OBSV", .stored = "abc", .raw_size = 3, .version = 7});
  expect_load_error(map,
                    ": chunk OBSV at byte 48 is required but not known: it needs version 7 of the "
                    "rmap format, and this release of rmap knows version 1");
  map = plain_;
  map.chunk("CELL").version = 2;
  expect_load_error(map,
                    ": chunk CELL at byte 428 is required but not known: it needs version 2 of the "
                    "rmap format, and this release of rmap knows version 1");
  map.chunks[3].type = {'A', '\n', '\x80', ' '};
  map.chunks[3].version = 1;
  expect_load_error(map,
                    ": chunk A\\x0a\\x80 at byte 428 is required but not known: it needs version 1 "
                    "of the rmap format, and this release of rmap knows version 1");
  for (const std::uint32_t version : {0U, 2U, 4294967295U}) {
    map = plain_;
    map.version = version;
    expect_load_error(map, " is in version " + std::to_string(version) +
                               " of the rmap format: this release of rmap reads version 1");
  }
  EXPECT_EQ(files_, 6U);
}

}  // namespace
}  // namespace rmap
