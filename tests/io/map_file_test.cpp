#include "io/files.hpp"
#include "io/map_samples.hpp"
#include "io/raw_map.hpp"

#include <algorithm>
#include <csignal>
#include <functional>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/map_file.hpp>

namespace rmap {
namespace {

using test::expect_error;
using test::Random;
using test::read_text;
using testing::ElementsAre;

class MapFile : public testing::Test {
 protected:
  std::string saved(const Grid& grid) {
    save(grid, file_);
    return read_text(file_);
  }

  // Loads what was saved in every way, and finds the same map that gives the same bytes.
  void expect_round_trip(const Grid& grid) {
    const std::string bytes = saved(grid);
    for (const LoadOptions& options : test::various_load_options()) {
      test::write_text(file_, bytes);
      const Grid loaded = load(file_, options);
      EXPECT_TRUE(same_map(grid, loaded));
      EXPECT_EQ(loaded.check(), std::nullopt);
      EXPECT_EQ(loaded.options(), test::with(grid.options(), options));
      EXPECT_TRUE(saved(loaded) == bytes);
      ++round_trips_;
    }
  }

  const test::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "a.rmap";
  int round_trips_ = 0;
};

TEST_F(MapFile, gives_back_maps_of_all_options) {
  Random random(1);
  SCOPED_TRACE(random.trace());
  for (const Options& options : test::various_options()) {
    expect_round_trip(Grid(options));
    expect_round_trip(test::random_map(random, options));
  }
  EXPECT_EQ(round_trips_, 6 * 2 * 4);
}

TEST_F(MapFile, gives_back_random_maps_and_holds_what_the_plain_twin_does) {
  Random random(2);
  SCOPED_TRACE(random.trace());
  std::size_t cells = 0;
  for (int i = 0; i < 60; ++i) {
    Options options = test::all_options_changed();
    if (random.chance(0.5)) options.layout = Layout::cells;
    const Grid grid = test::random_map(random, options);
    expect_round_trip(grid);
    const test::RawMap plain = test::raw_map(grid);
    ASSERT_EQ(test::decompressed(test::parsed(saved(grid))), plain);
    test::write_text(file_, test::bytes_of(plain));
    ASSERT_TRUE(same_map(load(file_), grid));
    cells += grid.cell_count();
  }
  EXPECT_EQ(round_trips_, 60 * 4);
  EXPECT_GT(cells, 10000U);
}

TEST_F(MapFile, gives_back_one_cell_wherever_it_is_and_whatever_its_value) {
  int cases = 0;
  for (const int x : {kMinCellIndex, -1, 0, kMaxCellIndex}) {
    for (const int z : {kMinCellIndex, -8, 7, kMaxCellIndex}) {
      for (const Value value : {Value{-32768}, Value{-1}, Value{0}, Value{32767}}) {
        Grid grid({.resolution = 0.1});
        grid.set_value({x, 3, z}, value);
        save(grid, file_);
        const Grid loaded = load(file_);
        EXPECT_EQ(loaded.cell_count(), 1U);
        EXPECT_EQ(loaded.cell_value({x, 3, z}), value);
        ++cases;
      }
    }
  }
  EXPECT_EQ(cases, 64);
}

TEST_F(MapFile, gives_back_a_full_block) {
  Grid grid({.resolution = 0.1});
  for (BlockPosition i = 0; i < kBlockCells; ++i) {
    grid.set_value(Cell(-8, 16, 0) + block_offset(i), static_cast<Value>(i));
  }
  expect_round_trip(grid);
  EXPECT_EQ(read_map_info(file_).blocks, 1U);
}

TEST_F(MapFile, spreads_large_maps_over_chunks) {
  Random random(3);
  SCOPED_TRACE(random.trace());
  Grid grid({.resolution = 0.1});
  for (int i = 0; i < 2 * 4096 + 1; ++i) {
    grid.set_value({8 * (i % 100), 8 * (i / 100), random.integer(-8, 7)},
                   static_cast<Value>(random.integer(-32768, 32767)));
  }
  grid.restore(History::first_hit, test::random_poses(random, 32768 + 1));
  expect_round_trip(grid);
  const test::RawMap plain = test::raw_map(grid);
  EXPECT_EQ(test::decompressed(test::parsed(read_text(file_))), plain);
  std::vector<std::string> types;
  for (const test::RawChunk& chunk : plain.chunks) types.push_back(chunk.type);
  EXPECT_THAT(types, ElementsAre("OPTS", "HIST", "POSE", "POSE", "CELL", "CELL", "CELL", "END "));
}

TEST_F(MapFile, of_equal_maps_is_equal_bytes) {
  Random random(4);
  SCOPED_TRACE(random.trace());
  int cases = 0;
  for (int i = 0; i < 10; ++i) {
    const Grid grid = test::random_map(random, test::all_options_changed());
    const std::string bytes = saved(grid);
    for (const LoadOptions& options : test::various_load_options()) {
      const Grid other = test::rebuilt(grid, random, test::with(grid.options(), options));
      ASSERT_TRUE(saved(other) == bytes);
      ++cases;
    }
  }
  EXPECT_EQ(cases, 40);
}

TEST_F(MapFile, does_not_tell_the_zeros_apart) {
  const auto with_zero = [](double zero) {
    Grid grid({.resolution = 0.1, .free_probability = zero, .min_range = zero});
    Pose pose = Pose::Identity();
    pose.translation().y() = zero;
    pose(0, 2) = zero;
    grid.restore(History::first_hit, {pose});
    return grid;
  };
  ASSERT_TRUE(same_map(with_zero(0.0), with_zero(-0.0)));
  EXPECT_EQ(saved(with_zero(0.0)), saved(with_zero(-0.0)));
}

TEST_F(MapFile, changes_with_everything_that_is_part_of_the_map) {
  const Grid grid = test::small_map();
  std::vector<std::string> files = {saved(grid)};
  const auto add = [&](const Options& options, const std::function<void(Grid&)>& change) {
    Grid other(options);
    other.merge(grid);
    other.restore(grid.history(), {grid.scan_poses().begin(), grid.scan_poses().end()});
    change(other);
    EXPECT_FALSE(same_map(grid, other)) << files.size();
    files.push_back(saved(other));
  };
  const auto nothing = [](Grid&) {};
  Options options = grid.options();
  const auto with_option = [&](auto Options::*option, auto value) {
    options = grid.options();
    options.*option = value;
    add(options, nothing);
  };
  with_option(&Options::prob_hit, 0.81);
  with_option(&Options::prob_miss, 0.31);
  with_option(&Options::clamp_min, 0.06);
  with_option(&Options::clamp_max, 0.98);
  with_option(&Options::occupied_threshold, 0.61);
  with_option(&Options::free_probability, 0.126);
  with_option(&Options::saturation, Saturation::clamp);
  with_option(&Options::min_range, 0.51);
  with_option(&Options::max_range, 81.0);
  with_option(&Options::beams, Beams::all);
  add(grid.options(), [](Grid& other) { other.set_value({0, 0, 0}, 101); });
  add(grid.options(), [](Grid& other) { other.set_value({0, 0, 1}, 100); });
  add(grid.options(), [](Grid& other) { other.restore(History::complete, {}); });
  add(grid.options(), [&](Grid& other) {
    other.restore(History::first_hit, {grid.scan_poses().begin(), grid.scan_poses().end()});
  });
  EXPECT_EQ(files.size(), 15U);
  std::sort(files.begin(), files.end());
  EXPECT_EQ(std::unique(files.begin(), files.end()), files.end());
}

TEST_F(MapFile, goes_on_as_if_it_had_never_been_saved) {
  Random random(5);
  SCOPED_TRACE(random.trace());
  const auto scan_from = [&](double x) {
    Scan scan;
    scan.map_from_sensor.translation() << x, 0.05, 0.05;
    for (int i = 0; i < 200; ++i) {
      scan.points.push_back((4 * random.direction()).cast<float>());
    }
    return scan;
  };
  const std::vector<Scan> scans = {scan_from(0), scan_from(0.5), scan_from(1)};
  Grid straight({.resolution = 0.1});
  Grid interrupted({.resolution = 0.1});
  for (const Scan& each : scans) {
    straight.insert(each);
    save(interrupted, file_);
    interrupted = load(file_);
    interrupted.insert(each);
  }
  EXPECT_GT(straight.cell_count(), 300U);
  EXPECT_TRUE(same_map(straight, interrupted));
}

TEST_F(MapFile, says_what_is_in_it) {
  const Grid grid = test::small_map();
  const std::string bytes = saved(grid);
  const MapFileInfo info = read_map_info(file_);
  EXPECT_EQ(info.format_version, 1U);
  EXPECT_EQ(info.file_size, bytes.size());
  EXPECT_EQ(info.options, grid.options());
  EXPECT_EQ(info.history, History::complete);
  EXPECT_EQ(info.scans, 2U);
  EXPECT_EQ(info.blocks, 4U);
  EXPECT_EQ(info.cells, 5U);
  const test::RawMap raw = test::parsed(bytes);
  ASSERT_EQ(info.chunks.size(), raw.chunks.size());
  std::vector<std::string> types;
  std::uint64_t offset = 48;
  for (std::size_t i = 0; i < raw.chunks.size(); ++i) {
    const MapChunk& chunk = info.chunks[i];
    types.push_back(chunk.type);
    EXPECT_TRUE(chunk.required);
    EXPECT_EQ(chunk.compressed, (raw.chunks[i].flags & 2) != 0);
    EXPECT_EQ(chunk.offset, offset);
    EXPECT_EQ(chunk.stored_size, raw.chunks[i].stored.size());
    EXPECT_EQ(chunk.raw_size, raw.chunks[i].raw_size);
    offset += 24 + chunk.stored_size + 8;
  }
  EXPECT_THAT(types, ElementsAre("OPTS", "HIST", "POSE", "CELL", "END"));
  EXPECT_EQ(offset, info.file_size);
}

TEST_F(MapFile, refuses_options_of_memory_that_do_not_fit) {
  save(test::small_map(), file_);
  EXPECT_THROW(load(file_, {.max_branches = 3}), Error);
  EXPECT_THROW(load(file_, {.threads = -1}), Error);
}

TEST_F(MapFile, takes_the_room_that_bounds_the_memory_for_it) {
  Grid grid({.resolution = 0.1});
  CellMask all;
  for (BlockPosition i = 0; i < kBlockCells; ++i) all.set(i);
  const std::vector<Value> values(kBlockCells, 3500);
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      const BlockValues block{{8 * i, 8 * j, 0}, all, values};
      grid.set_blocks({&block, 1});
    }
  }
  expect_round_trip(grid);
  const MapFileInfo info = read_map_info(file_);
  EXPECT_EQ(info.chunks[2].type, "CELL");
  EXPECT_EQ(info.chunks[2].stored_size, 10U * 400 + 400 * 512 / 8);

  Grid standing({.resolution = 0.1});
  standing.restore(History::first_hit, std::vector<Pose>(1000, Pose::Identity()));
  expect_round_trip(standing);
  EXPECT_EQ(read_map_info(file_).chunks[2].stored_size, 10U * 1000);
}

TEST_F(MapFile, is_complete_or_not_there_on_a_full_disk) {
  Random random(6);
  SCOPED_TRACE(random.trace());
  Grid grid({.resolution = 0.1});
  for (int i = 0; i < 30000; ++i) {
    grid.set_value(random.cell(-500, 500), static_cast<Value>(random.integer(-32768, 32767)));
  }
  expect_error(ErrorKind::io, "cannot write /dev/full: No space left on device",
               [&] { save(grid, "/dev/full"); });

  test::write_text(file_, "old");
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{.rlim_cur = 4096, .rlim_max = 4096};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) ::_exit(2);
    try {
      save(grid, file_);
    } catch (const Error& error) {
      ::_exit(error.kind() == ErrorKind::io ? 0 : 3);
    }
    ::_exit(4);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(read_text(file_), "old");
  EXPECT_THAT(folder_.names(), ElementsAre("a.rmap"));
}

}  // namespace
}  // namespace rmap
