#include <bit>
#include <cmath>
#include <iterator>
#include <map>
#include <unordered_map>
#include <unordered_set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/beam.hpp>
#include <rmap/error.hpp>
#include <rmap/lattice.hpp>
#include <rmap/simulation.hpp>

namespace rmap {
namespace {

static_assert(std::input_iterator<Simulation::Iterator>);

/// One small model of each kind of sensor.
std::vector<SensorModel> small_sensors() {
  return {SpinningLidar{.channels = 12,
                        .min_elevation = -40,
                        .max_elevation = 30,
                        .azimuth_steps = 60,
                        .min_range = 0.2,
                        .max_range = 60},
          SolidStateLidar{.beams = 500},
          DepthCamera{.width = 24, .height = 18, .fx = 20, .fy = 20, .cx = 11.5, .cy = 8.5}};
}

void expect_same(const Scan& a, const Scan& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.no_returns, b.no_returns);
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.map_from_sensor.matrix(), b.map_from_sensor.matrix());
}

// Goes along a beam by the distance to the nearest surface, so that no solid
// thicker than 1 mm is overseen, and asks whether it is in one.
void expect_free(const Scene& scene, const Vector3d& origin, const Vector3d& direction,
                 double length, double time) {
  for (double t = 0; t < length;) {
    const Vector3d point = origin + t * direction;
    ASSERT_FALSE(scene.solid_at(point, time)) << "at " << t << " of " << length << " m";
    t += std::max(scene.distance_to_surface(point, time), 1e-3);
  }
}

TEST(Simulation, every_scene_gives_true_scans_with_every_sensor) {
  int points = 0;
  int no_returns = 0;
  for (const std::string& name : scene_names()) {
    for (const SensorModel& sensor : small_sensors()) {
      const Simulation simulation =
          make_simulation(name, {.scans = 4, .sensor = sensor, .noise = 0.0});
      SCOPED_TRACE(name + ", sensor " + std::to_string(sensor.index()));
      int returns = 0;
      for (std::size_t i = 0; i < simulation.size(); ++i) {
        const Scan scan = simulation.scan(i);
        EXPECT_NO_THROW(check_pose(scan.map_from_sensor));
        const Vector3d origin = scan.map_from_sensor.translation();
        const double time = simulation.time(i);
        for (std::size_t k = 0; k < scan.points.size(); ++k) {
          const Vector3f& point = scan.points[k];
          ASSERT_TRUE(point.allFinite());
          const double length = point.cast<double>().norm();
          ASSERT_LE(length, scan.sensor_range * (1 + 1e-7));
          ASSERT_GT(length, 0.19);
          const Vector3d end = transformed(scan.map_from_sensor, point);
          // The rounding to float32, 4e-6 m at 60 m.
          ASSERT_LT(simulation.scene().distance_to_surface(end, time), length * 0x1p-24 + 1e-12);
          if (k % 5 == 0) {
            expect_free(simulation.scene(), origin, (end - origin) / length, length - 1e-5, time);
          }
          ++returns;
        }
        for (std::size_t k = 0; k < scan.no_returns.size(); k += 5) {
          const Vector3d direction = rotated(scan.map_from_sensor, scan.no_returns[k]);
          ASSERT_NEAR(direction.norm(), 1, 1e-6);
          expect_free(simulation.scene(), origin, direction, scan.sensor_range, time);
          ++no_returns;
        }
      }
      EXPECT_GT(returns, 20) << "the sensor sees something of the scene";
      points += returns;
    }
  }
  EXPECT_GT(points, 20000);
  EXPECT_GT(no_returns, 3000);
}

TEST(Simulation, scans_are_the_same_in_any_order_and_from_copies) {
  for (const SensorModel& sensor : small_sensors()) {
    const Simulation simulation = make_simulation(
        "moving", {.scans = 6, .sensor = sensor, .noise = 0.02, .dropped = 0.1, .seed = 3});
    std::vector<Scan> forward;
    for (const Scan& scan : simulation) forward.push_back(scan);
    ASSERT_EQ(forward.size(), 6u);
    const Simulation copy = simulation;  // NOLINT(performance-unnecessary-copy-initialization)
    const Simulation again = make_simulation(
        "moving", {.scans = 6, .sensor = sensor, .noise = 0.02, .dropped = 0.1, .seed = 3});
    for (std::size_t i = 6; i-- > 0;) {
      expect_same(simulation.scan(i), forward[i]);
      expect_same(copy.scan(i), forward[i]);
      expect_same(again.scan(i), forward[i]);
    }
    EXPECT_NE(forward[0].points, forward[1].points);
  }
}

TEST(Simulation, scans_come_with_the_poses_of_the_trajectory) {
  const Scenario scenario = make_scene("street", {.scans = 5});
  const Simulation lidar = make_simulation("street", {.scans = 5});
  const Simulation camera = make_simulation("street", {.scans = 5, .sensor = DepthCamera{}});
  ASSERT_EQ(lidar.size(), 5u);
  EXPECT_EQ(lidar.name(), "street");
  EXPECT_EQ(lidar.description(), scenario.description);
  for (std::size_t i = 0; i < 5; ++i) {
    const Pose& body = scenario.trajectory[i].map_from_body;
    EXPECT_EQ(lidar.time(i), scenario.trajectory[i].time);
    EXPECT_EQ(lidar.map_from_sensor(i).matrix(), body.matrix());
    EXPECT_EQ(camera.scan(i).map_from_sensor.matrix(), camera.map_from_sensor(i).matrix());
    EXPECT_EQ(rotated(camera.map_from_sensor(i), {0, 0, 1}), rotated(body, {1, 0, 0}));
  }
}

TEST(Simulation, options_reach_the_sensor_and_others_stay_the_scenes_own) {
  const Sensor room = make_simulation("noisy_room").sensor();
  EXPECT_EQ(room.noise, 0.01);
  EXPECT_EQ(make_simulation("noisy_room", {.noise = 0.0}).sensor().noise, 0);
  const Sensor own =
      make_simulation("room", {.noise = 0.5, .dropped = 0.25, .no_returns = false, .seed = 77})
          .sensor();
  EXPECT_EQ(own.noise, 0.5);
  EXPECT_EQ(own.dropped, 0.25);
  EXPECT_FALSE(own.no_returns);
  EXPECT_EQ(own.seed, 77u);
  EXPECT_TRUE(std::holds_alternative<SpinningLidar>(own.model));
}

void expect_refused(const std::string& name, const SimulationOptions& options,
                    const std::string& word) {
  try {
    make_simulation(name, options);
    ADD_FAILURE() << word << " was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), testing::HasSubstr(word));
  }
}

TEST(Simulation, names_and_options_that_make_no_sense_are_refused_by_name) {
  expect_refused("cellar", {}, "street");
  expect_refused("room", {.scans = -2}, "scans");
  expect_refused("room", {.noise = -1.0}, "noise");
  expect_refused("room", {.dropped = 2}, "dropped");
  expect_refused("room", {.sensor = SpinningLidar{.channels = -1}}, "channels");
}

// In a map of cells the cart must be cleared again: hits and misses of the cells
// in its way, counted by the definition of a crossing.
TEST(Simulation, later_beams_clear_all_that_the_cart_left) {
  const Simulation simulation = make_simulation("moving");
  const Lattice lattice(0.1);
  const CellBox way = lattice.cells_of({.min = {-5, -3.6, 0.2}, .max = {4.8, 2.8, 2}});
  constexpr int kHit = 847;
  constexpr int kMiss = -405;
  std::unordered_map<Cell, int, CellHash> values;
  std::size_t most = 0;
  for (const Scan& scan : simulation) {
    const Vector3d origin = lattice.to_cells(scan.map_from_sensor.translation());
    std::unordered_set<Cell, CellHash> hit;
    std::unordered_set<Cell, CellHash> missed;
    std::vector<Beam> beams;
    for (const Vector3f& point : scan.points) {
      const Vector3d end = transformed(scan.map_from_sensor, point);
      const Cell cell = lattice.cell_of(end);
      if (way.contains(cell)) hit.insert(cell);
      beams.emplace_back(origin, lattice.to_cells(end), false);
    }
    for (const Cell& cell : hit) values.try_emplace(cell, 0);
    for (const Beam& beam : beams) {
      for (BeamWalk walk(beam, way); walk.more(); walk.advance()) {
        if (values.contains(walk.cell()) && !hit.contains(walk.cell())) missed.insert(walk.cell());
      }
    }
    for (const Cell& cell : hit) values[cell] = std::min(values[cell] + kHit, 3511);
    for (const Cell& cell : missed) values[cell] = std::max(values[cell] + kMiss, -2000);
    std::size_t occupied = 0;
    for (const auto& [cell, value] : values) occupied += value > 0 ? 1 : 0;
    most = std::max(most, occupied);
  }
  EXPECT_GT(most, 500u);
  for (const auto& [cell, value] : values) {
    const bool of_the_scene =
        simulation.scene().distance_to_surface(lattice.center(cell),
                                               simulation.time(simulation.size() - 1)) < 0.1;
    EXPECT_TRUE(value <= 0 || of_the_scene)
        << "the cart's ghost at " << lattice.center(cell).transpose() << ": " << value;
  }
}

/// FNV-1a over the bits of all numbers of a scan.
std::uint64_t fingerprint(const Scan& scan) {
  std::uint64_t hash = 0xCBF29CE484222325u;
  const auto add = [&](float value) {
    hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0x100000001B3u;
  };
  for (const Vector3f& point : scan.points) std::for_each(point.begin(), point.end(), add);
  for (const Vector3f& beam : scan.no_returns) std::for_each(beam.begin(), beam.end(), add);
  return hash;
}

TEST(Simulation, scans_are_the_same_bits_with_every_compiler_and_machine) {
  // The sensor of the tilted room is turned with it, hence sees the same.
  const std::map<std::string, std::uint64_t> golden = {
      {"box", 0x44ED3AE49E75CA8Eu},         {"sphere", 0x4C0B2A21CC4E11FFu},
      {"room", 0xD3EF18CB285E9AADu},        {"noisy_room", 0xD3EF18CB285E9AADu},
      {"tilted_room", 0xD3EF18CB285E9AADu}, {"stairs", 0x3A9A4702A4FC4221u},
      {"street", 0x797169311D021B19u},      {"campus", 0xA56B78CF9FCBA188u},
      {"moving", 0x3DCFDE67A952E7E6u}};
  ASSERT_EQ(golden.size(), scene_names().size());
  for (const auto& [name, expected] : golden) {
    std::uint64_t combined = 0;
    for (const SensorModel& sensor : small_sensors()) {
      const Simulation simulation =
          make_simulation(name, {.scans = 3, .sensor = sensor, .noise = 0.01, .dropped = 0.1});
      for (const Scan& scan : simulation) combined = combined * 31 + fingerprint(scan);
    }
    EXPECT_EQ(combined, expected) << name << ": 0x" << std::hex << combined;
  }
}

}  // namespace
}  // namespace rmap
