#include "io/files.hpp"
#include "io/map_samples.hpp"
#include "io/raw_map.hpp"

#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include <rmap/map_file.hpp>

namespace rmap {
namespace {

using test::raw;
using test::raw_chunk;
using test::RawChunk;
using test::RawMap;

constexpr std::uint64_t kHuge = std::numeric_limits<std::uint64_t>::max();
constexpr std::size_t kLargestContent = 8 + 4096 * (12 + 8 + 64 + 1024);

// Files of which every checksum is right and something else is wrong: each change of a
// sound map must be refused with its sentence.
class HostileMap : public testing::Test {
 protected:
  void expect_refused(const std::function<void(RawMap&)>& change, const std::string& sentence) {
    RawMap map = test::raw_map(test::small_map());
    change(map);
    test::write_text(file_, bytes_of(map));
    test::expect_error(ErrorKind::input, file_.string() + sentence, [&] { load(file_); });
    ++cases_;
  }

  // The content of a chunk is changed from `offset` on.
  template <class T>
  void expect_refused(const std::string& type, std::size_t offset, T number,
                      const std::string& sentence) {
    expect_refused(
        [&](RawMap& map) { map.chunk(type).stored.replace(offset, sizeof(T), raw(number)); },
        sentence);
  }

  static void replace(RawMap& map, const std::string& type, const std::string& content) {
    map.chunk(type) = raw_chunk(type, content);
  }

  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "a.rmap";
  int cases_ = 0;
};

TEST_F(HostileMap, is_refused_for_its_options) {
  const std::string start = ": chunk OPTS at byte 48 ";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < 10; ++i) {
    RawMap map = test::raw_map(test::small_map());
    map.chunk("OPTS").stored.replace(8 * i, 8, raw(nan));
    test::write_text(file_, bytes_of(map));
    EXPECT_THROW(load(file_), Error) << i;
    EXPECT_THROW(read_map_info(file_), Error) << i;
    ++cases_;
  }
  expect_refused("OPTS", 0, -1.0,
                 start +
                     "holds options that are not allowed: resolution is -1 m: it must lie in "
                     "1e-06 to 1000000 m");
  expect_refused("OPTS", 80, 2U, start + "has 2 for saturation: at most 1 is known");
  expect_refused("OPTS", 84, 4294967295U, start + "has 4294967295 for beams: at most 1 is known");
  expect_refused([](RawMap& map) { replace(map, "OPTS", std::string(87, 'x')); },
                 start + "has 87 bytes of content: it must have 88");
  EXPECT_EQ(cases_, 14);
}

TEST_F(HostileMap, is_refused_for_its_history_and_poses) {
  expect_refused("HIST", 0, 2U,
                 ": chunk HIST at byte 168 has 2 for the history: at most 1 is known");
  expect_refused([](RawMap& map) { replace(map, "HIST", ""); },
                 ": chunk HIST at byte 168 has 0 bytes of content: it must have 4");
  const std::string start = ": chunk POSE at byte 204 ";
  for (const std::size_t size : {0U, 95U, 191U}) {
    expect_refused([&](RawMap& map) { replace(map, "POSE", std::string(size, '\0')); },
                   start + "has " + std::to_string(size) +
                       " bytes of content: it must have a multiple of 96, and at least one");
  }
  expect_refused("POSE", 96 + 24, std::numeric_limits<double>::infinity(),
                 start +
                     "holds no pose at byte 96 of its content: the pose holds a number that is "
                     "not finite");
  expect_refused("POSE", 0, -1.0,
                 start +
                     "holds no pose at byte 0 of its content: the 3x3 part of the pose is no "
                     "rotation but a reflection: its determinant is -1");
  EXPECT_EQ(cases_, 7);
}

TEST_F(HostileMap, is_refused_for_its_counts) {
  expect_refused([](RawMap& map) { map.scans = kHuge; },
                 " holds 2 scan poses, but its header announces 18446744073709551615");
  expect_refused([](RawMap& map) { map.blocks = 5; },
                 " holds 4 blocks, but its header announces 5");
  expect_refused([](RawMap& map) { map.cells = 0; }, " holds 5 cells, but its header announces 0");
  expect_refused(
      [](RawMap& map) { replace(map, "END ", raw<std::uint64_t>(5)); },
      ": chunk END at byte 563 must hold 8 bytes with the number of chunks before it, 4");
  expect_refused(
      [](RawMap& map) { replace(map, "END ", ""); },
      ": chunk END at byte 563 must hold 8 bytes with the number of chunks before it, 4");
  EXPECT_EQ(cases_, 5);
}

TEST_F(HostileMap, is_refused_for_the_order_of_its_chunks) {
  const auto out_of_order = [](const std::string& chunk) {
    return ": chunk " + chunk +
           " is out of order: OPTS, HIST, POSE, CELL and END must come in this order, and only "
           "POSE and CELL may be missing or repeated";
  };
  expect_refused([](RawMap& map) { map.chunks.erase(map.chunks.begin()); },
                 ": chunk HIST at byte 48 comes before chunk OPTS, which must come first");
  expect_refused([](RawMap& map) { map.chunks.erase(map.chunks.begin() + 1); },
                 ": chunk POSE at byte 168 comes before chunk HIST, which must come first");
  expect_refused([](RawMap& map) { map.chunks = {raw_chunk("END ", raw<std::uint64_t>(0))}; },
                 ": chunk END at byte 48 comes before chunk OPTS, which must come first");
  expect_refused([](RawMap& map) { std::swap(map.chunks[2], map.chunks[3]); },
                 out_of_order("POSE at byte 339"));
  expect_refused([](RawMap& map) { map.chunks.insert(map.chunks.begin(), map.chunks[0]); },
                 out_of_order("OPTS at byte 168"));
  EXPECT_EQ(cases_, 5);
}

TEST_F(HostileMap, is_refused_for_its_sizes) {
  const std::string start = ": chunk CELL at byte 428 ";
  expect_refused([](RawMap& map) { map.chunk("CELL").raw_size = kHuge; },
                 start +
                     "is not compressed and takes 103 bytes, but announces "
                     "18446744073709551615");
  expect_refused(
      [](RawMap& map) {
        map.chunk("CELL").raw_size = kLargestContent + 1;
        map.chunk("CELL").flags = 3;
      },
      start + "announces 4538377 bytes once decompressed: at most 4538376 are allowed");
  expect_refused([](RawMap& map) { replace(map, "CELL", std::string(kLargestContent + 1, 'x')); },
                 start + "takes 4538377 bytes: at most 4538376 are allowed");
  expect_refused([](RawMap& map) { map.chunk("CELL").flags = 5; },
                 start + "has flags 0x5: version 1 knows 0x3");
  EXPECT_EQ(cases_, 4);
}

TEST_F(HostileMap, is_refused_for_its_compression) {
  const auto sentence = [](std::size_t size) {
    return ": chunk CELL at byte 428 does not decompress: it must be one zstd frame of " +
           std::to_string(size) + " bytes, followed by zeros";
  };
  const auto compressed = [](RawMap& map, const std::string& stored, std::uint64_t raw_size) {
    map.chunk("CELL") = {.type = "CELL", .stored = stored, .raw_size = raw_size, .flags = 3};
  };
  const std::string frame = test::zstd_frame(std::string(1000, 'x'));
  for (const std::string& stored :
       {std::string(), std::string("x"), frame.substr(0, frame.size() - 1), frame + "x",
        frame + frame, std::string(1, '\0') + frame}) {
    expect_refused([&](RawMap& map) { compressed(map, stored, 1000); }, sentence(1000));
  }
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{999}, std::size_t{1001}, kLargestContent}) {
    expect_refused([&](RawMap& map) { compressed(map, frame, size); }, sentence(size));
  }
  // What would be a thousand times its size in memory.
  const std::string bomb = test::zstd_frame(std::string(std::size_t{1} << 24, '\0'));
  expect_refused([&](RawMap& map) { compressed(map, bomb, 8); }, sentence(8));
  EXPECT_EQ(cases_, 11);
}

// A map of these blocks as it would be, were it sound: of each column one part.
struct Columns {
  std::uint32_t blocks;
  std::uint32_t cells;
  std::string indices;
  std::string summaries;
  std::string masks;
  std::string values;

  std::string content() const {
    return raw(blocks) + raw(cells) + indices + summaries + masks + values;
  }
};

// One block at the origin with one cell, the first.
Columns one_cell() {
  return {1, 1, std::string(12, '\0'), '\1' + std::string(7, '\0'), "\1", raw<Value>(7)};
}

TEST_F(HostileMap, is_refused_for_its_blocks) {
  const auto expect = [&](const std::function<void(Columns&)>& change, const std::string& wrong) {
    Columns columns = one_cell();
    change(columns);
    expect_refused([&](RawMap& map) { replace(map, "CELL", columns.content()); },
                   ": chunk CELL at byte 428 " + wrong);
  };
  const std::string too_little = "has too little content: ";
  expect([](Columns& c) { c.blocks = 0; }, "has 0 blocks: it must have 1 to 4096");
  expect([](Columns& c) { c.blocks = 4097; }, "has 4097 blocks: it must have 1 to 4096");
  expect([](Columns& c) { c.blocks = 4096; },
         too_little + "49129 bytes more are announced than there are");
  expect([](Columns& c) { c.cells = 4294967295U; },
         too_little + "8589934588 bytes more are announced than there are");
  expect([](Columns& c) { c.cells = 2; }, too_little + "2 bytes more are announced than there are");
  expect([](Columns& c) { c.values += "x"; }, "has 1 bytes of content too many");
  expect([](Columns& c) { c.masks = '\0'; }, "has a byte of a mask that is zero and must not be");
  expect(
      [](Columns& c) {
        c.summaries[0] = '\0';
        c.masks = "";
      },
      "has no cell in block 0");
  expect([](Columns& c) { c.masks = "\3"; }, "has values for 1 cells, and more cells in its masks");
  expect(
      [](Columns& c) {
        c.cells = 2;
        c.values += c.values;
      },
      "has values for 2 cells, and only 1 cells in its masks");
  // Steps of 2^27 blocks up and 2^27 + 1 down lead beyond the limits: zigzag 2^28 and 2^28 + 1.
  expect([](Columns& c) { c.indices[3] = '\x10'; },
         "has block 0 at 134217728 times 8 cells along axis 0: indices of cells must lie in "
         "-1073741824 to 1073741823");
  expect(
      [](Columns& c) {
        c.indices[8] = '\1';
        c.indices[11] = '\x10';
      },
      "has block 0 at -134217729 times 8 cells along axis 2: indices of cells must lie in "
      "-1073741824 to 1073741823");
  EXPECT_EQ(cases_, 12);
}

TEST_F(HostileMap, is_refused_for_blocks_out_of_order) {
  const auto two_blocks = [](const std::string& x_steps) {
    return Columns{2,
                   2,
                   x_steps + std::string(22, '\0'),
                   '\1' + std::string(7, '\0') + '\1' + std::string(7, '\0'),
                   "\1\1",
                   raw<Value>(7) + raw<Value>(8)}
        .content();
  };
  // To block 1 along x, then by 0 or back by one: zigzag 2, then 0 or 1.
  expect_refused(
      [&](RawMap& map) {
        replace(map, "CELL", two_blocks({'\2', '\0'}));
      },
      ": chunk CELL at byte 428 has block 1 at cell (8, 0, 0), which must come behind "
      "the block at (8, 0, 0) in Morton order");
  expect_refused(
      [&](RawMap& map) {
        replace(map, "CELL", two_blocks({'\2', '\1'}));
      },
      ": chunk CELL at byte 428 has block 1 at cell (0, 0, 0), which must come behind "
      "the block at (8, 0, 0) in Morton order");
  // Across chunks too.
  expect_refused(
      [](RawMap& map) {
        map.chunks.insert(map.chunks.begin() + 3, raw_chunk("CELL", one_cell().content()));
      },
      ": chunk CELL at byte 491 has block 0 at cell (-8, -8, -8), which must come behind the block "
      "at (0, 0, 0) in Morton order");
  EXPECT_EQ(cases_, 3);
}

TEST_F(HostileMap, is_refused_where_it_takes_too_little_room_for_what_it_holds) {
  Grid grid({.resolution = 0.1});
  for (int i = 0; i < 1000; ++i) grid.set_value({8 * i, 0, 0}, 7);
  grid.restore(History::first_hit, std::vector<Pose>(500, Pose::Identity()));
  RawMap map = test::raw_map(grid);
  const auto expect = [&](const std::string& type, std::size_t least, const std::string& wrong) {
    RawMap dense = map;
    RawChunk& chunk = dense.chunk(type);
    chunk.stored = test::zstd_frame(chunk.stored);
    chunk.flags = 3;
    ASSERT_LT(chunk.stored.size(), least - 1);
    chunk.stored.resize(least - 1);
    test::write_text(file_, bytes_of(dense));
    test::expect_error(ErrorKind::input, file_.string() + wrong, [&] { load(file_); });
    dense.chunk(type).stored.push_back('\0');
    test::write_text(file_, bytes_of(dense));
    EXPECT_TRUE(same_map(load(file_), grid));
    ++cases_;
  };
  expect("POSE", 5000,
         ": chunk POSE at byte 204 takes 4999 bytes for 48000 bytes of poses: it must take at "
         "least 5000");
  expect("CELL", 10125,
         ": chunk CELL at byte 48236 takes 10124 bytes for 1000 blocks with 1000 cells: it must "
         "take at least 10125");
  EXPECT_EQ(cases_, 2);
}

}  // namespace
}  // namespace rmap
