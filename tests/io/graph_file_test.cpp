#include "io/graph_file.hpp"

#include "io/files.hpp"
#include "io/scan_samples.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>

namespace rmap {
namespace {

using test::graph_vector;
using test::raw;
using test::write_text;

std::string node(double x, std::uint32_t id) {
  return raw(std::uint32_t{2}) + graph_vector({x, 2, 3}) + graph_vector({4, 5, 6}) +
         graph_vector({10, 20, x}) + graph_vector({0, 0, 0, 1}) + raw(id);
}

std::string graph() {
  return raw(std::uint32_t{2}) + node(1, 7) + node(9, 8) + raw(std::uint32_t{0});
}

TEST(GraphFile, reads_scans_with_their_poses) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.graph";
  write_text(file, graph());
  const auto source = open_scans(file, {.offset = {10, 0, 0}});
  EXPECT_EQ(source->size(), 2u);
  for (int pass = 0; pass < 2; ++pass, source->rewind()) {
    Scan scan;
    ASSERT_TRUE(source->next(scan));
    ASSERT_TRUE(source->next(scan));
    EXPECT_EQ(scan.points, (std::vector<Vector3f>{{9, 2, 3}, {4, 5, 6}}));
    EXPECT_EQ(scan.map_from_sensor.translation(), Vector3d(0, 20, 9));
    // The quaternion comes as w x y z: half a turn about z.
    EXPECT_TRUE(transformed(scan.map_from_sensor, {1, 0, 0}).isApprox(Vector3d(-1, 20, 9)));
    EXPECT_EQ(scan.name, file + ", scan 8");
    EXPECT_FALSE(source->next(scan));
  }
}

TEST(GraphFile, notices_every_cut) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.graph";
  const std::string whole = graph();
  std::size_t cuts = 0;
  for (std::size_t size = 0; size < whole.size(); ++size, ++cuts) {
    write_text(file, whole.substr(0, size));
    EXPECT_THROW(
        {
          const auto source = open_scans(file);
          for (Scan scan; source->next(scan);) {
          }
        },
        Error)
        << size;
  }
  EXPECT_EQ(cuts, whole.size());
  for (const std::string more : {"x", "\1\1\1\1"}) {
    write_text(file, whole + more);
    const auto source = open_scans(file);
    Scan scan;
    ASSERT_TRUE(source->next(scan));
    ASSERT_TRUE(source->next(scan));
    EXPECT_THROW(source->next(scan), Error);
    EXPECT_FALSE(source->next(scan));
  }
}

TEST(GraphFile, believes_no_number) {
  const test::TemporaryFolder folder;
  const std::string file = folder / "a.graph";
  for (const std::size_t place : {0u, 4u, 8u, 64u}) {
    std::string bytes = graph();
    bytes.replace(place, 4, "\xff\xff\xff\x7f");
    write_text(file, bytes);
    EXPECT_THROW(
        {
          const auto source = open_scans(file);
          for (Scan scan; source->next(scan);) {
          }
        },
        Error)
        << place;
  }
}

}  // namespace
}  // namespace rmap
