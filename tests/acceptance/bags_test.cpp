// A sequence of real scans written as a bag builds the map of its folder, bit for bit. Bags hold
// quaternions: the poses of the folder are those that they make.
#include "support/bag_messages.hpp"
#include "support/bag_writer.hpp"
#include "support/real_data.hpp"

#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <rmap/grid.hpp>
#include <rmap/scan_source.hpp>

namespace rmap {
namespace {

constexpr std::int64_t kStart = 1'690'309'709'284'305'601;
constexpr std::int64_t kStep = 100'000'007;

class Bags : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    const auto folder = test::sequence_folder(GetParam());
    if (folder.empty()) {
      GTEST_SKIP() << "the sequence " << GetParam() << " is not there: set RMAP_DATA";
    }
    std::string name = std::filesystem::temp_directory_path() / "rmap-bags-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("cannot create " + name);
    folder_ = name;
    for (const Scan& scan : read_scans(folder)) add(scan);
  }
  void TearDown() override {
    if (!folder_.empty()) std::filesystem::remove_all(folder_);
  }

  void add(const Scan& scan) {
    const std::int64_t stamp = kStart + static_cast<std::int64_t>(scans_.size()) * kStep;
    const Eigen::Matrix3d rotation = scan.map_from_sensor.linear();
    const test::TestTransform transform{.stamp = stamp,
                                        .parent = "map",
                                        .child = "lidar",
                                        .translation = scan.map_from_sensor.translation(),
                                        .rotation = Eigen::Quaterniond(rotation)};
    bag_.add("/tf", "tf2_msgs/msg/TFMessage", stamp, test::transforms_message({transform}));
    bag_.add("/odom", "nav_msgs/msg/Odometry", stamp, test::odometry_message(transform, true));
    bag_.add("/points", "sensor_msgs/msg/PointCloud2", stamp + 5,
             test::cloud_of(scan.points, stamp).message());
    const Eigen::Quaterniond& q = transform.rotation;
    trajectory_ +=
        fmt::format("{}.{:09} {} {} {} {} {} {} {}\n", stamp / 1'000'000'000, stamp % 1'000'000'000,
                    transform.translation.x(), transform.translation.y(), transform.translation.z(),
                    q.x(), q.y(), q.z(), q.w());
    scans_.push_back(scan);
    scans_.back().map_from_sensor = make_pose(transform.translation, q);
  }

  Grid map_of_scans() const {
    Grid grid({.resolution = 0.1});
    for (const Scan& scan : scans_) grid.insert(scan);
    return grid;
  }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
  }
  void expect_same_map(const std::string& name, const ScanReadOptions& options) const {
    SCOPED_TRACE(name);
    Grid grid({.resolution = 0.1});
    for (const Scan& scan : read_scans(folder_ / name, options)) grid.insert(scan);
    EXPECT_GT(grid.cell_count(), 1000u);
    EXPECT_TRUE(same_map(grid, map_of_scans()));
  }

  std::filesystem::path folder_;
  test::TestBag bag_;
  std::vector<Scan> scans_;
  std::string trajectory_;
};

INSTANTIATE_TEST_SUITE_P(Sequences, Bags, testing::Values("corridor_tilt", "stationary_outdoor"),
                         [](const auto& sequence) { return sequence.param; });

TEST_P(Bags, GiveTheMapOfTheFolder) {
  write("none.mcap", test::mcap_bytes(bag_));
  write("zstd.mcap", test::mcap_bytes(bag_, {.compression = test::TestCompression::zstd}));
  write("lz4.mcap", test::mcap_bytes(bag_, {.messages_per_chunk = 1,
                                            .compression = test::TestCompression::lz4}));
  test::write_db3(bag_, folder_ / "lone.db3");
  test::write_rosbag2(bag_, folder_ / "folder", false, 2);
  write("t.txt", trajectory_);
  for (const std::string name : {"none.mcap", "zstd.mcap", "lz4.mcap", "lone.db3", "folder"}) {
    expect_same_map(name, {});
    expect_same_map(name, {.bag = {.pose_topic = "/odom"}});
    expect_same_map(name, {.trajectory = folder_ / "t.txt"});
  }
}

}  // namespace
}  // namespace rmap
