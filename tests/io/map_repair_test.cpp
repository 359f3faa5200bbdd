#include "io/files.hpp"
#include "io/map_samples.hpp"
#include "io/raw_map.hpp"
#include "support/grids.hpp"

#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/cells.hpp>
#include <rmap/map_file.hpp>
#include <rmap/map_repair.hpp>

namespace rmap {
namespace {

using test::RawChunk;
using test::RawMap;

/// A map in many small chunks, so that damage touches few of them: four CELL, two POSE.
class MapRepairs : public testing::Test {
 protected:
  struct Part {
    std::string type;
    std::size_t begin;
    std::size_t end;  ///< behind its checksum
    std::vector<CellValue> cells = {};
    std::size_t poses = 0;
  };

  MapRepairs() : grid_(test::small_map()) {
    grid_.set_value({9, 1, 0}, 50);
    grid_.restore(History::complete, {grid_.scan_poses().begin(), grid_.scan_poses().end()});
    const RawMap whole = test::raw_map(grid_);
    RawMap split{.scans = whole.scans, .blocks = whole.blocks, .cells = whole.cells};
    split.chunks = {whole.chunks[0], whole.chunks[1]};
    for (const Pose& pose : grid_.scan_poses()) {
      split.chunks.push_back(test::raw_chunk("POSE", test::pose_bytes(pose)));
    }
    // One block in each: what a map of its cells alone would be written as.
    std::vector<std::vector<CellValue>> blocks;
    for (const CellValue& entry : cells(grid_)) {
      if (blocks.empty() || block_origin(blocks.back().front().cell) != block_origin(entry.cell)) {
        blocks.emplace_back();
      }
      blocks.back().push_back(entry);
    }
    for (const auto& block : blocks) {
      Grid part(grid_.options());
      for (const auto& [cell, value] : block) part.set_value(cell, value);
      RawMap raw = test::raw_map(part);
      split.chunks.push_back(raw.chunk("CELL"));
    }
    split.chunks.push_back(test::raw_chunk("END ", test::raw<std::uint64_t>(split.chunks.size())));
    bytes_ = bytes_of(split);

    std::size_t at = 48;
    std::size_t block = 0;
    for (const RawChunk& chunk : split.chunks) {
      Part part{.type = chunk.type, .begin = at, .end = at + 24 + chunk.stored.size() + 8};
      if (chunk.type == "CELL") part.cells = blocks[block++];
      if (chunk.type == "POSE") part.poses = 1;
      at = part.end;
      parts_.push_back(part);
    }
    EXPECT_EQ(at, bytes_.size());
    EXPECT_EQ(block, 4u);
  }

  std::filesystem::path file() const { return folder_ / "a.rmap"; }

  MapRepair repaired(const std::string& bytes) const {
    test::write_text(file(), bytes);
    return repair_map(file(), {.resolution = grid_.options().resolution});
  }

  // All that the parts hold for which `kept` holds is there again, and nothing else.
  template <class Kept>
  void expect_kept(const std::string& bytes, Kept&& kept) {
    ++cases_;
    const MapRepair repair = repaired(bytes);
    EXPECT_FALSE(repair.problems.empty());
    EXPECT_FALSE(check_map_file(file()).empty());
    std::vector<CellValue> expected;
    std::size_t poses = 0;
    bool history = true;
    bool options = true;
    for (const Part& part : parts_) {
      if (kept(part)) {
        expected.insert(expected.end(), part.cells.begin(), part.cells.end());
        poses += part.poses;
      } else {
        history = history && part.type != "CELL" && part.type != "HIST";
        options = options && part.type != "OPTS";
      }
    }
    std::vector<CellValue> found;
    for (const CellValue& entry : cells(repair.grid)) found.push_back(entry);
    EXPECT_EQ(found, expected);
    EXPECT_EQ(repair.salvaged.cells, expected.size());
    EXPECT_EQ(repair.salvaged.scans, poses);
    EXPECT_EQ(repair.grid.scan_poses().size(), poses);
    EXPECT_EQ(repair.options_lost, !options);
    EXPECT_EQ(repair.grid.options().prob_hit, options ? 0.8 : 0.7);
    EXPECT_EQ(repair.history_lost, !history);
    EXPECT_EQ(repair.grid.history(), history ? History::complete : History::first_hit);
  }

  Grid grid_;
  std::string bytes_;
  std::vector<Part> parts_;
  const test::TemporaryFolder folder_;
  std::size_t cases_ = 0;
};

TEST_F(MapRepairs, ASoundMapIsItself) {
  const MapRepair repair = repaired(bytes_);
  EXPECT_TRUE(repair.problems.empty());
  EXPECT_TRUE(same_map(repair.grid, grid_));
  EXPECT_TRUE(same_map(load(file()), grid_));
  EXPECT_TRUE(check_map_file(file()).empty());
  EXPECT_FALSE(repair.history_lost);
  ASSERT_TRUE(repair.announced);
  EXPECT_EQ(repair.announced->cells, grid_.cell_count());
  EXPECT_EQ(repair.salvaged.blocks, 4u);
}

TEST_F(MapRepairs, EveryFlippedBitCostsItsChunkAlone) {
  for (std::size_t i = 0; i < bytes_.size(); ++i) {
    for (int bit = 0; bit < 8; ++bit) {
      SCOPED_TRACE(fmt::format("bit {} of byte {}", bit, i));
      std::string damaged = bytes_;
      damaged[i] = static_cast<char>(damaged[i] ^ 1 << bit);
      // A damaged checksum costs nothing: the next chunk confirms what it stands for.
      expect_kept(damaged, [&](const Part& part) { return i < part.begin || i >= part.end - 8; });
      ASSERT_FALSE(HasFailure());
    }
  }
  EXPECT_EQ(cases_, 8 * bytes_.size());
}

TEST_F(MapRepairs, EveryCutCostsWhatIsBehindIt) {
  for (std::size_t length = 49; length < bytes_.size(); ++length) {
    SCOPED_TRACE(length);
    if (length < parts_.front().end) {
      test::write_text(file(), bytes_.substr(0, length));
      EXPECT_THROW(repair_map(file()), Error);
    }
    expect_kept(bytes_.substr(0, length), [&](const Part& part) { return part.end <= length; });
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_EQ(cases_, bytes_.size() - 49);
}

TEST_F(MapRepairs, EveryPieceThatIsMissingCostsWhatItTouches) {
  for (const std::size_t size : {std::size_t{1}, std::size_t{7}, std::size_t{40}}) {
    for (std::size_t at = 0; at + size < bytes_.size(); ++at) {
      SCOPED_TRACE(fmt::format("{} bytes from byte {} on", size, at));
      std::string damaged = bytes_;
      damaged.erase(at, size);
      // A chunk whose checksum is cut needs the next one at its side, and that needs the
      // checksum before it: both are as well as touched when it is not whole.
      const MapRepair repair = repaired(damaged);
      std::set<std::vector<int>> found;
      for (const auto& [cell, value] : cells(repair.grid)) {
        found.insert({cell.x(), cell.y(), cell.z(), value});
      }
      for (const Part& part : parts_) {
        // With the eight bytes before it, from which anybody can verify it alone.
        if (part.end > at && part.begin - 8 < at + size) continue;
        for (const auto& [cell, value] : part.cells) {
          EXPECT_TRUE(found.contains({cell.x(), cell.y(), cell.z(), value}));
        }
      }
      for (const auto& entry : found) {
        EXPECT_EQ(grid_.cell_value({entry[0], entry[1], entry[2]}), entry[3]);
      }
      EXPECT_FALSE(repair.problems.empty());
      ASSERT_FALSE(HasFailure());
      ++cases_;
    }
  }
  EXPECT_EQ(cases_, 3 * bytes_.size() - 48);
}

TEST_F(MapRepairs, GarbageInBetweenCostsWhatItStandsIn) {
  test::Random random(11);
  SCOPED_TRACE(random.trace());
  for (std::size_t at = 0; at <= bytes_.size(); ++at) {
    SCOPED_TRACE(at);
    std::string garbage;
    for (int i = random.integer(1, 100); i > 0; --i) {
      garbage += static_cast<char>(random.integer(0, 255));
    }
    std::string damaged = bytes_;
    damaged.insert(at, garbage);
    // Not by what stands before or behind a chunk, nor within its checksum but for END.
    expect_kept(damaged, [&](const Part& part) {
      const bool within = at > part.begin && at <= part.end - 8;
      return !within;
    });
    ASSERT_FALSE(HasFailure());
  }
  EXPECT_EQ(cases_, bytes_.size() + 1);
}

TEST_F(MapRepairs, AllProblemsAreTold) {
  std::string damaged = bytes_;
  const Part& first = parts_[4];
  const Part& third = parts_[6];
  ASSERT_EQ(first.type, "CELL");
  damaged[first.begin + 30] ^= 1;
  damaged[third.begin + 30] ^= 1;
  test::write_text(file(), damaged);
  const auto problems = check_map_file(file());
  ASSERT_EQ(problems.size(), 4u);
  const std::string start = file().string() + " is damaged: the checksum of chunk CELL at byte ";
  EXPECT_EQ(problems[0].sentence, start + std::to_string(first.begin) + " does not fit its bytes");
  EXPECT_EQ(problems[0].chunk, "CELL");
  EXPECT_EQ(problems[0].offset, first.begin);
  EXPECT_EQ(problems[0].size, first.end - first.begin);
  EXPECT_EQ(problems[1].offset, third.begin);
  EXPECT_EQ(problems[2].sentence,
            file().string() + " holds 2 blocks that are sound, but its header announces 4");
  EXPECT_EQ(problems[3].sentence,
            file().string() + " holds 3 cells that are sound, but its header announces 6");
  EXPECT_FALSE(problems[3].offset);
  // Two that follow one another are told apart too.
  damaged = bytes_;
  damaged[first.begin + 30] ^= 1;
  damaged[parts_[5].begin + 30] ^= 1;
  test::write_text(file(), damaged);
  EXPECT_EQ(check_map_file(file())[1].offset, parts_[5].begin);
}

TEST_F(MapRepairs, WithoutOptionsAResolutionIsNeeded) {
  std::string damaged = bytes_;
  damaged[60] ^= 1;
  test::write_text(file(), damaged);
  test::expect_error(ErrorKind::input,
                     file().string() +
                         " has lost its options, chunk OPTS, and without them its cells mean "
                         "nothing: give the resolution that it was made with (--resolution) to "
                         "salvage it with default options",
                     [&] { repair_map(file()); });
  const MapRepair repair = repair_map(file(), {.resolution = 0.5});
  EXPECT_TRUE(repair.options_lost);
  EXPECT_EQ(repair.grid.options(), (Options{.resolution = 0.5}));
  EXPECT_EQ(repair.grid.cell_count(), grid_.cell_count());
  EXPECT_EQ(repair.grid.history(), History::complete);
  test::write_text(file(), bytes_);
  test::expect_error(
      ErrorKind::input,
      file().string() + " has a resolution of 0.25 m by its options, which are sound, not 0.5 m",
      [&] { repair_map(file(), {.resolution = 0.5}); });
}

TEST_F(MapRepairs, OtherFilesAreRefused) {
  for (const std::string& bytes :
       {std::string(), std::string("ply\n"), std::string(10000, 'C'),
        bytes_of(RawMap{.chunks = test::raw_map(grid_).chunks, .version = 2})}) {
    test::write_text(file(), bytes);
    EXPECT_THROW(repair_map(file()), Error);
    EXPECT_EQ(check_map_file(file()).size(), 1u);
  }
  EXPECT_THROW(repair_map(folder_ / "missing.rmap"), Error);
  EXPECT_THROW(check_map_file(folder_ / "missing.rmap"), Error);
}

TEST_F(MapRepairs, WhatOnlyLooksLikeChunksEndsTheSearchSometime) {
  // Every 24 bytes the start of a chunk of megabytes.
  std::string start = "CELL" + test::raw<std::uint16_t>(1) + test::raw<std::uint16_t>(1) +
                      test::raw<std::uint64_t>(4'000'000) + test::raw<std::uint64_t>(4'000'000);
  std::string hostile = bytes_.substr(0, parts_[1].end);
  while (hostile.size() < 5'000'000) hostile += start;
  const MapRepair repair = repaired(hostile);
  EXPECT_EQ(repair.grid.cell_count(), 0u);
  EXPECT_FALSE(repair.problems.empty());
}

TEST_F(MapRepairs, RandomMapsKeepWhatIsNotTouched) {
  int cases = 0;
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    test::Random random(seed);
    SCOPED_TRACE(random.trace());
    Grid grid({.resolution = 0.1});
    for (int i = 0; i < 20000; ++i) grid.set(random.cell(-300, 300), 0.8);
    save(grid, file());
    const std::string bytes = test::read_text(file());
    for (int flips = 1; flips < 4; ++flips, ++cases) {
      std::string damaged = bytes;
      for (int i = 0; i < flips; ++i) {
        const auto at = static_cast<std::size_t>(
            random.integer(200, static_cast<std::int32_t>(bytes.size()) - 41));
        damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
      }
      test::write_text(file(), damaged);
      const MapRepair repair = repair_map(file());
      EXPECT_LT(repair.grid.cell_count(), grid.cell_count());
      for (const auto& [cell, value] : cells(repair.grid)) {
        ASSERT_EQ(grid.cell_value(cell), value);
      }
      ASSERT_TRUE(repair.announced);
      EXPECT_EQ(repair.announced->cells, grid.cell_count());
    }
  }
  EXPECT_EQ(cases, 15);
}

}  // namespace
}  // namespace rmap
