// Seeds of scans in the formats that the library only reads.
#include "io/scan_samples.hpp"
#include "seeds.hpp"
#include "support/bag_messages.hpp"
#include "support/bag_writer.hpp"

#include <vector>

namespace rmap::test {

namespace {

const std::vector<Vector3f> kPoints = {{1, 2, 3}, {-4, 0.5F, 1e-3F}, {7, 8, -9}};

std::string floats() { return bytes_of(kPoints); }

std::string ply(const std::string& form, const std::string& data) {
  return "ply\nformat " + form + " 1.0\ncomment made here\nelement vertex 3\nproperty float x\n" +
         "property float y\nproperty float z\nelement face 1\n" +
         "property list uchar int vertex_indices\nend_header\n" + data;
}

std::string graph() {
  return raw(std::uint32_t{1}) + raw(std::uint32_t{2}) + graph_vector({1, 2, 3}) +
         graph_vector({4, 5, 6}) + graph_vector({0, 0, 1}) + graph_vector({1, 0, 0, 0}) +
         raw(std::uint32_t{0}) + raw(std::uint32_t{0});
}

TestBag drive() {
  TestBag bag;
  bag.add("/tf_static", "tf2_msgs/msg/TFMessage", 0,
          transforms_message({{.stamp = 0, .parent = "base", .child = "lidar"}}));
  for (std::int64_t second = 0; second < 2; ++second) {
    const std::int64_t stamp = second * 1'000'000'000;
    bag.add("/tf", "tf2_msgs/msg/TFMessage", stamp,
            transforms_message({{.stamp = stamp, .parent = "odom", .child = "base"}}));
    bag.add("/points", "sensor_msgs/msg/PointCloud2", stamp, cloud_of(kPoints, stamp).message());
  }
  return bag;
}

}  // namespace

void add_clouds(Seeds& seeds) {
  const std::string faces =
      "\3" + raw(std::int32_t{0}) + raw(std::int32_t{1}) + raw(std::int32_t{2});
  seeds.add("ply", "little", ply("binary_little_endian", floats() + faces));
  seeds.add("ply", "big", ply("binary_big_endian", floats() + std::string(1, '\0')));
  seeds.add("ply", "ascii", ply("ascii", "1 2 3\n-4 .5 1e-3\n7 8 nan\n3 0 1 2\n"));
  seeds.add("las", "v1_2", Las{}.bytes());
  seeds.add("las", "v1_4", Las{.minor = 4}.bytes());
  seeds.add("text_points", "plain", "1 2 3\n-4 0.5 1e-3\n# end\n");
  seeds.add("text_points", "named", "\"y\", x ,z,ox,oy,oz\n1,2,3,0,0,0\n4,5,nan,0,0,1.5\n");
  seeds.add("text_points", "counted", "2\n1;2;3\n4;5;6\n");
  seeds.add("tdtk", "scan", "100 200 300\n-4 0.5 1e-3 0.7\n");
  seeds.add("tdtk_pose", "pose", "100 200 300\n12 -34 56.7\n");
  seeds.add("graph", "one_scan", graph());
  seeds.add("trajectory", "tum", "1690309709.284305600 1 2 3 0 0 0 1\n1690309710 4 5 6 0 0 1 0\n");
  seeds.add("trajectory", "kitti", "1 0 0 1 0 1 0 2 0 0 1 3\n");
  seeds.add("calibration", "kitti",
            "P0: 1 0 0 0 0 1 0 0 0 0 1 0\nTr: -1 0 0 0.25 0 -1 0 0 0 0 1 0\n");
}

void add_bags(Seeds& seeds) {
  const TestBag bag = drive();
  seeds.add("mcap", "plain", mcap_bytes(bag, {.messages_per_chunk = 0}));
  seeds.add("mcap", "chunks", mcap_bytes(bag, {.checksums = false}));
  seeds.add("mcap", "lz4", mcap_bytes(bag, {.compression = TestCompression::lz4}));
  seeds.add("mcap", "zstd",
            mcap_bytes(bag, {.compression = TestCompression::zstd, .summary = false}));
  const TemporaryFolder folder;
  write_db3(bag, folder / "drive.db3", 512);
  seeds.add("db3", "drive", read_text(folder / "drive.db3"));
  seeds.add("cloud_message", "points", cloud_of(kPoints, 7).message());
  seeds.add("cloud_message", "big", cloud_of(kPoints, 7).message(true));
  seeds.add("metadata", "mcap",
            "rosbag2_bagfile_information:\n  version: 5\n  storage_identifier: mcap\n"
            "  relative_file_paths:\n    - a.mcap\n  compression_format: \"\"\n"
            "  compression_mode: \"\"\n");
}

}  // namespace rmap::test
