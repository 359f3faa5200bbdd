#include "mappers/sequences.hpp"

#include "support/octomap_twin.hpp"
#include "support/scans.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/scan_source.hpp>
#include <rmap/simulation.hpp>

namespace rmap::bench {

namespace {

constexpr const char* kSimulated = "street_simulated";

template <class Scans>
Sequence take(const std::string& name, Scans&& scans, const Share& share) {
  Sequence sequence{name, {}};
  for (const Scan& scan : scans) {
    if (share.scans != 0 && sequence.scans.size() == share.scans) break;
    sequence.scans.push_back(test::in_map_frame(test::thinned(scan, share.stride)));
  }
  return sequence;
}

Pose place(double x, double y, double z) {
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(x, y, z);
  return pose;
}

void add_box(Scene& scene, const Vector3d& min, const Vector3d& max) {
  const Vector3d center = (min + max) / 2;
  scene.add({.name = fmt::format("box {}", scene.objects().size()),
             .shape = CuboidShape{max - min},
             .map_from_object = place(center.x(), center.y(), center.z())});
}

constexpr double kBlock = 50;

// A block of a city, kBlock metres long: houses, trees, poles and parked cars on both sides.
void add_city_block(Scene& scene, test::Random& random, double x) {
  for (const double side : {-1.0, 1.0}) {
    const double front = side * random.real(9, 11);
    const double back = front + side * random.real(10, 14);
    add_box(scene, {x + random.real(1, 4), std::min(front, back), 0},
            {x + random.real(40, 48), std::max(front, back), random.real(6, 18)});
    for (const double along : {10.0, 30.0}) {
      const double car = x + along + random.real(-3, 3);
      add_box(scene, {car, side * 3.9 - 0.9, 0.2}, {car + 4.3, side * 3.9 + 0.9, 1.5});
      const double tree = x + along + random.real(4, 8);
      scene.add({.name = fmt::format("trunk {}", scene.objects().size()),
                 .shape = CylinderShape{0.15, 4},
                 .map_from_object = place(tree, side * 6.5, 0)});
      scene.add({.name = fmt::format("crown {}", scene.objects().size()),
                 .shape = SphereShape{random.real(1, 2)},
                 .map_from_object = place(tree, side * 6.5, 4.5)});
    }
  }
}

}  // namespace

std::size_t Sequence::beams() const {
  std::size_t beams = 0;
  for (const Scan& scan : scans) beams += scan.points.size();
  return beams;
}

std::vector<Sequence> read_sequences(const std::filesystem::path& data,
                                     const std::vector<std::string>& names, const Share& share) {
  std::vector<std::filesystem::path> folders;
  if (std::filesystem::is_directory(data / "sequences")) {
    for (const auto& entry : std::filesystem::directory_iterator(data / "sequences")) {
      if (entry.is_directory()) folders.push_back(entry.path());
    }
  }
  std::sort(folders.begin(), folders.end());

  const auto is_wanted = [&](const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
  };
  std::vector<Sequence> sequences;
  for (const auto& folder : folders) {
    const std::string name = folder.filename().string();
    if (is_wanted(name)) sequences.push_back(take(name, read_scans(folder), share));
  }
  if (is_wanted(kSimulated)) {
    sequences.push_back(take(kSimulated, make_simulation("street"), share));
  }
  for (const std::string& name : names) {
    const auto has_name = [&](const Sequence& sequence) { return sequence.name == name; };
    if (std::none_of(sequences.begin(), sequences.end(), has_name)) {
      throw Error(ErrorKind::input, fmt::format("no sequence \"{}\" in {}", name, data.string()));
    }
  }
  return sequences;
}

Sequence simulate_drive(double metres) {
  constexpr double kAhead = 150;  // more than the sensor sees
  Scene scene("drive");
  test::Random random(1);
  scene.add({.name = "ground",
             .shape = RectangleShape{metres + 2 * kAhead, 60},
             .map_from_object = place(metres / 2, 0, 0)});
  const int blocks = static_cast<int>((metres + 2 * kAhead) / kBlock);
  for (int i = 0; i < blocks; ++i) add_city_block(scene, random, kBlock * i - kAhead);
  const Sensor sensor{.model = make_sensor("lidar16"), .noise = 0.01};
  Sequence sequence{fmt::format("drive of {} m", metres), {}};
  const auto scans = static_cast<std::uint64_t>(metres / 5);
  for (std::uint64_t i = 0; i < scans; ++i) {
    const Pose pose = place(5 * static_cast<double>(i), -1.5, 1.8);
    sequence.scans.push_back(test::in_map_frame(simulate_scan(scene, sensor, pose, 0, i)));
  }
  return sequence;
}

}  // namespace rmap::bench
