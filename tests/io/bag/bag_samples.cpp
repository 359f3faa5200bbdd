#include "io/bag/bag_samples.hpp"

#include <utility>

namespace rmap::test {

void add_transform(TestBag& bag, std::int64_t stamp, std::string parent, std::string child,
                   const Vector3d& translation, const char* topic) {
  bag.add(topic, kTransformType, stamp,
          transforms_message({{.stamp = stamp,
                               .parent = std::move(parent),
                               .child = std::move(child),
                               .translation = translation}}));
}

void add_cloud(TestBag& bag, std::int64_t stamp, float x, const char* topic, const char* frame) {
  const std::vector<Vector3f> points = {{x, 2, 3}};
  bag.add(topic, kCloudType, stamp, cloud_of(points, stamp, frame).message());
}

TestBag driving_bag(int clouds) {
  TestBag bag;
  add_transform(bag, kStart, "base", "lidar", {0, 0, 0.5}, "/tf_static");
  for (int i = 0; i < clouds; ++i) {
    const std::int64_t stamp = kStart + i * kSecond;
    add_transform(bag, stamp, "odom", "base", {1.0 * i, 0, 0});
    bag.add(
        "/odom", kOdometryType, stamp,
        odometry_message(
            {.stamp = stamp, .parent = "odom", .child = "base", .translation = {1.0 * i, 0, 0}}));
    add_cloud(bag, stamp, static_cast<float>(i));
  }
  return bag;
}

std::vector<ReadScan> scans_of(const std::filesystem::path& bag, const ScanReadOptions& options) {
  std::vector<ReadScan> scans;
  const auto source = open_scans(bag, options);
  for (Scan scan; source->next(scan);) {
    scans.push_back({scan.points.at(0).x(), scan.map_from_sensor.translation().x()});
  }
  return scans;
}

}  // namespace rmap::test
