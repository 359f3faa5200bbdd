#include "io/files.hpp"

#include <algorithm>
#include <ranges>
#include <type_traits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/scan_files.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

using test::expect_error;
using testing::ElementsAre;

static_assert(std::ranges::input_range<ScanRange>);
static_assert(!std::ranges::forward_range<ScanRange>);
static_assert(std::movable<ScanRange> && !std::copyable<ScanRange>);
static_assert(std::is_same_v<std::ranges::range_reference_t<ScanRange>, const Scan&>);

// A folder of scans that are known by the x of their only point.
void write_folder(const std::filesystem::path& folder, const std::vector<float>& xs) {
  ScanFolderWriter writer(folder);
  for (const float x : xs) writer.add({.points = {{x, 0, 0}}});
  writer.finish();
}

std::vector<float> xs_of(ScanRange& scans) {
  std::vector<float> xs;
  for (const Scan& scan : scans) xs.push_back(scan.points.at(0).x());
  return xs;
}

TEST(ScanRange, is_read_in_a_loop) {
  const test::TemporaryFolder folder;
  write_folder(folder / "a", {1, 2, 3});
  std::vector<float> xs;
  for (const Scan& scan : read_scans(folder / "a/")) xs.push_back(scan.points.at(0).x());
  EXPECT_THAT(xs, ElementsAre(1, 2, 3));
}

TEST(ScanRange, passes_again_after_rewind_and_not_before) {
  const test::TemporaryFolder folder;
  write_folder(folder / "a", {1, 2, 3});
  ScanRange scans = read_scans(folder / "a");
  EXPECT_EQ(scans.size(), 3u);
  EXPECT_THAT(xs_of(scans), ElementsAre(1, 2, 3));
  const std::string sentence =
      "a pass over the scans has begun already: rewind() allows another one";
  expect_error(ErrorKind::usage, sentence, [&] { xs_of(scans); });
  scans.rewind();
  EXPECT_THAT(xs_of(scans), ElementsAre(1, 2, 3));

  scans.rewind();
  for (const Scan& scan : scans) {
    if (scan.points.at(0).x() == 2) break;
  }
  expect_error(ErrorKind::usage, sentence, [&] { xs_of(scans); });
  scans.rewind();
  ScanRange moved = std::move(scans);
  EXPECT_THAT(xs_of(moved), ElementsAre(1, 2, 3));
}

TEST(ScanRange, works_with_iterators_and_algorithms) {
  const test::TemporaryFolder folder;
  write_folder(folder / "a", {1, 2, 3});
  ScanRange scans = read_scans(folder / "a");
  auto iterator = scans.begin();
  EXPECT_EQ(iterator->points.at(0).x(), 1);
  iterator++;
  EXPECT_EQ((*iterator).points.at(0).x(), 2);
  ++iterator;
  EXPECT_FALSE(iterator == scans.end());
  ++iterator;
  EXPECT_TRUE(iterator == scans.end());
  scans.rewind();
  EXPECT_EQ(
      std::ranges::count_if(scans, [](const Scan& scan) { return scan.points.at(0).x() > 1; }), 2);
}

TEST(ScanRange, throws_where_the_bad_scan_is) {
  const test::TemporaryFolder folder;
  write_folder(folder / "a", {1, 2, 3});
  test::write_text(folder / "a/000001.bin", "");
  ScanRange scans = read_scans(folder / "a");
  auto iterator = scans.begin();
  expect_error(ErrorKind::input,
               (folder / "a/000001.bin").string() +
                   " is empty: a .bin scan holds at least one point of 16 bytes",
               [&] { ++iterator; });
}

TEST(ScanSequence, reads_paths_one_after_another) {
  const test::TemporaryFolder folder;
  write_folder(folder / "a", {1, 2});
  write_folder(folder / "b", {3, 4, 5});
  ScanRange scans = read_scan_sequence({folder / "b", folder / "a/000001.bin", folder / "a"});
  EXPECT_EQ(scans.size(), 6u);
  EXPECT_THAT(xs_of(scans), ElementsAre(3, 4, 5, 2, 1, 2));
  scans.rewind();
  EXPECT_THAT(xs_of(scans), ElementsAre(3, 4, 5, 2, 1, 2));
  ScanRange alone = read_scan_sequence({folder / "b"});
  EXPECT_THAT(xs_of(alone), ElementsAre(3, 4, 5));
}

TEST(ScanSequence, checks_all_paths_when_opened) {
  const test::TemporaryFolder folder;
  write_folder(folder / "a", {1});
  const std::string missing = folder / "missing";
  expect_error(ErrorKind::io, "cannot open " + missing + ": No such file or directory", [&] {
    open_scan_sequence({folder / "a", missing});
  });
  expect_error(ErrorKind::usage, "no path of scans is given: at least one is needed",
               [] { open_scan_sequence({}); });
}

TEST(OpenScans, refuses_what_holds_no_scans) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "map.rmap";
  test::write_text(file, "");
  expect_error(ErrorKind::input,
               file +
                   " holds no scans as far as its name says: folders, bags (.mcap, .db3) and files "
                   "ending in .graph, .bin, .pcd, .ply, .las, .laz, .3d, .xyz, .csv, .txt and .dat "
                   "are allowed",
               [&] { open_scans(file); });
  expect_error(ErrorKind::io, "cannot open : No such file or directory", [] { open_scans(""); });
}

TEST(OpenScans, takes_a_file_of_the_current_folder) {
  const test::TemporaryFolder folder;
  write_folder(folder / "a", {1, 2});
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder / "a");
  ScanRange scans = read_scans("000001.bin");
  EXPECT_THAT(xs_of(scans), ElementsAre(2));
  std::filesystem::current_path(before);
}

}  // namespace
}  // namespace rmap
