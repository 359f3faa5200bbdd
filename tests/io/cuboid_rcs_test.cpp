// A golden file is written once, with the release that brings its format version:
//
//     io_tests --gtest_also_run_disabled_tests --gtest_filter='CuboidRcs.DISABLED_write_*'

#include "io/cuboid_samples.hpp"
#include "io/files.hpp"

#include <functional>
#include <limits>

#include <gtest/gtest.h>
#include <xxhash.h>
#include <zstd.h>

#include <rmap/cuboid_files.hpp>

namespace rmap {
namespace {

using test::raw;

const std::filesystem::path kGoldenV1 = std::filesystem::path(RMAP_GOLDEN_DIR) / "v1_cuboids.rcs";

// A file field by field, as docs/formats/rcs.md has it.
struct RawList {
  std::string magic = "\x89RCS\r\n\x1A\n";
  std::uint32_t version = 1;
  std::uint32_t flags = 0;
  double resolution = 0.1;
  std::string frame;
  std::uint64_t count = 0;
  std::string content;
};

std::string bytes_of(const RawList& list) {
  const std::string bytes = list.magic + raw(list.version) + raw(list.flags) +
                            raw(list.resolution) + list.frame + raw(list.count) + list.content;
  return bytes + raw<std::uint64_t>(XXH3_64bits(bytes.data(), bytes.size()));
}

template <class T>
std::string planes(const std::vector<T>& numbers) {
  std::string bytes;
  for (std::size_t plane = 0; plane < sizeof(T); ++plane) {
    for (const T number : numbers) bytes += static_cast<char>(number >> (8 * plane));
  }
  return bytes;
}

std::string content_of(const CuboidList& list) {
  std::string content;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::uint32_t> steps;
    std::int64_t before = 0;
    for (const Cuboid& cuboid : list.cuboids) {
      const std::int64_t step =
          cuboid.cells.min[axis] - std::exchange(before, cuboid.cells.min[axis]);
      steps.push_back(static_cast<std::uint32_t>(step >= 0 ? 2 * step : -2 * step - 1));
    }
    content += planes(steps);
  }
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::uint32_t> edges;
    for (const Cuboid& cuboid : list.cuboids) {
      edges.push_back(static_cast<std::uint32_t>(cuboid.cells.extent()[axis] - 1));
    }
    content += planes(edges);
  }
  std::vector<std::uint64_t> points;
  for (const Cuboid& cuboid : list.cuboids) points.push_back(cuboid.points);
  return content + planes(points);
}

RawList raw_list(const CuboidList& list) {
  RawList result;
  result.resolution = list.resolution;
  result.count = list.cuboids.size();
  result.content = content_of(list);
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) result.frame += raw(list.frame(row, column));
  }
  return result;
}

std::string zstd_frame(const std::string& content) {
  std::string frame(ZSTD_compressBound(content.size()), '\0');
  frame.resize(ZSTD_compress(frame.data(), frame.size(), content.data(), content.size(), 3));
  return frame;
}

// Cuboids of every kind, and enough of them for compression to pay.
CuboidList golden_list() {
  CuboidList list = test::small_list();
  list.cuboids.push_back(
      {.cells = all_cells(), .points = std::numeric_limits<std::uint64_t>::max()});
  list.cuboids.push_back({.cells = box_of(Cell::Constant(kMaxCellIndex)), .points = 1});
  list.cuboids.push_back({.cells = box_of(Cell::Constant(kMinCellIndex)), .points = 2});
  for (int i = 0; i < 100; ++i) {
    const Cell corner(i * 7 % 50, -i, i / 10);
    list.cuboids.push_back({.cells = {.min = corner, .max = corner + Cell(1 + i % 3, 2, 1)},
                            .points = static_cast<std::uint64_t>(1000 - i)});
  }
  return list;
}

// One cuboid, all of whose numbers fill their bytes.
CuboidList incompressible_list() {
  CuboidList list = test::small_list();
  list.cuboids = {{.cells = {.min = {0x01234567, -0x02345678, 0x0ABCDEF1},
                             .max = {0x31415926, 0x27182817, 0x16180339}},
                   .points = 0x0123456789ABCDEF}};
  return list;
}

TEST(CuboidRcs, DISABLED_write_v1) { write_cuboids(kGoldenV1, golden_list()); }

TEST(CuboidRcs, of_version_1_is_read) {
  const CuboidList list = read_cuboids(kGoldenV1);
  EXPECT_EQ(list.cuboids.size(), 105U);
  EXPECT_TRUE(test::same(list, golden_list()));
}

// The same bytes with the same zstd only; what they decompress to is the same with any.
TEST(CuboidRcs, is_what_the_docs_say) {
  const CuboidList list = golden_list();
  RawList expected = raw_list(list);
  expected.flags = 1;
  expected.content = zstd_frame(expected.content);
  EXPECT_EQ(test::written(".rcs", list), bytes_of(expected));
  // What would not become smaller is kept as it is.
  EXPECT_EQ(test::written(".rcs", incompressible_list()),
            bytes_of(raw_list(incompressible_list())));
  EXPECT_EQ(test::written(".rcs", {}).size(), 136U);
}

TEST(CuboidRcs, takes_a_byte_a_cuboid_at_least) {
  CuboidList list = test::small_list();
  list.cuboids.resize(100000, list.cuboids[0]);
  const std::string bytes = test::written(".rcs", list);
  EXPECT_EQ(bytes.size(), 128 + 100000 + 8U);
  const test::TemporaryFolder folder;
  test::write_text(folder / "a.rcs", bytes);
  EXPECT_TRUE(test::same(read_cuboids(folder / "a.rcs"), list));
}

TEST(CuboidRcs, is_the_same_for_equal_lists) {
  CuboidList list = test::small_list();
  list.frame(0, 3) = 0;
  const std::string bytes = test::written(".rcs", list);
  list.frame(0, 3) = -0.0;
  EXPECT_EQ(test::written(".rcs", list), bytes);
}

TEST(CuboidRcs, is_refused_when_cut_or_longer) {
  const test::TemporaryFolder folder;
  std::size_t cases = 0;
  std::size_t sizes = 0;
  for (const CuboidList& list : {incompressible_list(), test::small_list(), golden_list()}) {
    const std::string bytes = test::written(".rcs", list);
    sizes += bytes.size();
    for (std::size_t size = 0; size < bytes.size() + 20; ++size) {
      if (size == bytes.size()) continue;
      std::string damaged = bytes.substr(0, size);
      damaged.resize(size, '\0');
      test::write_text(folder / "a.rcs", damaged);
      try {
        read_cuboids(folder / "a.rcs");
        ADD_FAILURE() << size << " of " << bytes.size() << " bytes";
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
      }
      ++cases;
    }
  }
  EXPECT_EQ(cases, sizes + 3 * 19);
}

TEST(CuboidRcs, is_refused_for_every_flipped_bit) {
  const test::TemporaryFolder folder;
  std::size_t cases = 0;
  std::size_t sizes = 0;
  for (const CuboidList& list : {incompressible_list(), test::small_list(), CuboidList{}}) {
    const std::string bytes = test::written(".rcs", list);
    sizes += bytes.size();
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      std::string damaged = bytes;
      damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
      test::write_text(folder / "a.rcs", damaged);
      try {
        read_cuboids(folder / "a.rcs");
        ADD_FAILURE() << "bit " << bit;
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
      }
      ++cases;
    }
  }
  EXPECT_EQ(cases, 8 * sizes);
  EXPECT_GT(sizes, 3 * 136U);
}

// Files of which the checksum is right and something else is wrong.
class HostileRcs : public testing::Test {
 protected:
  void expect_refused(const std::string& sentence, const std::function<void(RawList&)>& change) {
    RawList list = raw_list(test::small_list());
    change(list);
    const auto file = folder_ / "a.rcs";
    test::write_text(file, bytes_of(list));
    test::expect_error(ErrorKind::input, file.string() + " " + sentence,
                       [&] { read_cuboids(file); });
    ++cases_;
  }

  const test::TemporaryFolder folder_;
  int cases_ = 0;
};

TEST_F(HostileRcs, header_is_refused) {
  expect_refused(
      "is not an rcs file, or damaged: its first 8 bytes are not those that every rcs file "
      "begins with",
      [](RawList& list) { list.magic = "\x89RCS\n\x1A\n\n"; });
  for (const std::uint32_t version : {0U, 2U, 4294967295U}) {
    expect_refused("is in version " + std::to_string(version) +
                       " of the rcs format: this release of rmap reads version 1",
                   [&](RawList& list) { list.version = version; });
  }
  expect_refused("has flags 0x2: version 1 knows 0x1", [](RawList& list) { list.flags = 2; });
  expect_refused("has no sound header: resolution is nan m: it must lie in 1e-06 to 1000000 m",
                 [](RawList& list) { list.resolution = std::numeric_limits<double>::quiet_NaN(); });
  expect_refused(
      "has no sound header: holds no pose at byte 0 of its content: the pose holds a "
      "number that is not finite",
      [](RawList& list) {
        list.frame.replace(0, 8, raw(std::numeric_limits<double>::infinity()));
      });
  expect_refused("is cut off: it has 72 bytes, and an rcs file has at least 136",
                 [](RawList& list) {
                   list.frame.resize(32);
                   list.content.clear();
                 });
  EXPECT_EQ(cases_, 8);
}

TEST_F(HostileRcs, count_is_refused) {
  constexpr std::uint64_t kHuge = std::numeric_limits<std::uint64_t>::max();
  for (const std::uint64_t count :
       std::initializer_list<std::uint64_t>{0, 1, 3, 1000, kHuge, kHuge / 32 + 3}) {
    expect_refused("announces " + std::to_string(count) +
                       " cuboids, which do not fit the 64 bytes that it has for them",
                   [&](RawList& list) { list.count = count; });
  }
  // Any count that the length of the file allows is only a promise.
  for (const std::uint64_t count : {0, 1, 3, 30}) {
    expect_refused("does not decompress: it must hold one zstd frame of " +
                       std::to_string(32 * count) + " bytes, followed by zeros",
                   [&](RawList& list) {
                     list.flags = 1;
                     list.count = count;
                     list.content = zstd_frame(list.content);
                   });
  }
  expect_refused(
      "announces 1000000 cuboids, which do not fit the 999999 bytes that it has for them",
      [&](RawList& list) {
        list.flags = 1;
        list.count = 1000000;
        list.content.resize(999999);
      });
  EXPECT_EQ(cases_, 11);
}

TEST_F(HostileRcs, content_is_refused) {
  const std::string unsound =
      "does not decompress: it must hold one zstd frame of 64 bytes, followed by zeros";
  const auto compressed = [](RawList& list) {
    list.flags = 1;
    list.content = zstd_frame(list.content);
  };
  expect_refused(unsound, [](RawList& list) { list.flags = 1; });
  expect_refused(unsound, [&](RawList& list) {
    compressed(list);
    list.content += "x";
  });
  expect_refused(unsound, [&](RawList& list) {
    compressed(list);
    list.content += zstd_frame("x");
  });
  expect_refused(unsound, [&](RawList& list) {
    compressed(list);
    list.content.pop_back();
  });
  const auto with = [](Cuboid cuboid) {
    CuboidList hostile = test::small_list();
    hostile.cuboids[1] = cuboid;
    return content_of(hostile);
  };
  expect_refused(
      "holds cuboid 1 from 1073741823 to 1073741825 on axis y, which is beyond the limits "
      "of cell indices",
      [&](RawList& list) {
        list.content =
            with({.cells = {.min = {0, kMaxCellIndex, 0}, .max = {1, kMaxCellIndex + 2, 1}}});
      });
  expect_refused(
      "holds cuboid 1 from -1073741825 to 1 on axis x, which is beyond the limits of cell "
      "indices",
      [&](RawList& list) {
        list.content = with({.cells = {.min = {kMinCellIndex - 1, 0, 0}, .max = {1, 1, 1}}});
      });
  // An empty cuboid has the edge -1, which is a very long one as the file has it.
  expect_refused(
      "holds cuboid 1 from 0 to 4294967296 on axis z, which is beyond the limits of cell "
      "indices",
      [&](RawList& list) {
        list.content = with({.cells = {.min = {0, 0, 0}, .max = {1, 1, 0}}});
      });
  EXPECT_EQ(cases_, 7);
}

}  // namespace
}  // namespace rmap
