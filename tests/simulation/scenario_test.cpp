#include <cmath>
#include <limits>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rmap/error.hpp>
#include <rmap/simulation/scenario.hpp>

namespace rmap {
namespace {

constexpr double kOff = 0.0033;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

double limit_of(const SensorModel& model) {
  return std::visit([](const auto& sensor) { return sensor.min_range; }, model);
}

int count_named(const Scene& scene, const std::string& word) {
  int count = 0;
  for (const SceneObject& object : scene.objects()) {
    if (object.name.find(word) != std::string::npos) ++count;
  }
  return count;
}

/// Range along an axis from a point that is given without the shift off the cells' borders.
double range(const Scene& scene, const Vector3d& from, const Vector3d& direction) {
  const auto hit = scene.first_hit(from + Vector3d::Constant(kOff), direction, kInfinity);
  return hit ? hit->range : kInfinity;
}

TEST(Scenario, every_name_makes_a_sound_scene) {
  EXPECT_THAT(scene_names(),
              testing::UnorderedElementsAre("box", "sphere", "room", "noisy_room", "tilted_room",
                                            "stairs", "street", "campus", "moving"));
  for (const std::string& name : scene_names()) {
    SCOPED_TRACE(name);
    const Scenario scenario = make_scene(name);
    EXPECT_EQ(scenario.scene.name(), name);
    EXPECT_GT(scenario.description.size(), 10u);
    EXPECT_NO_THROW(check_sensor(scenario.sensor));
    ASSERT_FALSE(scenario.trajectory.empty());
    EXPECT_EQ(scenario.trajectory[0].time, 0);
    for (std::size_t i = 0; i < scenario.trajectory.size(); ++i) {
      const TimedPose& pose = scenario.trajectory[i];
      EXPECT_NO_THROW(check_pose(pose.map_from_body));
      if (i > 0) {
        EXPECT_GT(pose.time, scenario.trajectory[i - 1].time);
      }
      const Vector3d origin = pose.map_from_body.translation();
      EXPECT_FALSE(scenario.scene.solid_at(origin, pose.time));
      EXPECT_GT(scenario.scene.distance_to_surface(origin, pose.time),
                limit_of(scenario.sensor.model))
          << "something is too near to be seen from pose " << i;
    }
  }
}

TEST(Scenario, names_that_are_none_are_refused_with_the_list) {
  try {
    make_scene("kitchen");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::input);
    EXPECT_THAT(error.what(), testing::HasSubstr("'kitchen'"));
    for (const std::string& name : scene_names()) {
      EXPECT_THAT(error.what(), testing::HasSubstr(name));
    }
  }
}

TEST(Scenario, scans_may_be_any_number_within_the_limits) {
  for (const std::string& name : scene_names()) {
    for (const int scans : {1, 2, 7}) {
      EXPECT_EQ(make_scene(name, {.scans = scans}).trajectory.size(),
                static_cast<std::size_t>(scans));
    }
  }
  for (const int scans : {-1, 1'000'001}) {
    try {
      make_scene("box", {.scans = scans});
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::input);
      EXPECT_THAT(error.what(), testing::HasSubstr("scans"));
    }
  }
}

TEST(Scenario, more_scans_take_the_same_way_and_time) {
  const Scenario few = make_scene("street", {.scans = 3});
  const Scenario many = make_scene("street", {.scans = 41});
  EXPECT_DOUBLE_EQ(few.trajectory.back().time, many.trajectory.back().time);
  EXPECT_TRUE(few.trajectory[1].map_from_body.isApprox(many.trajectory[20].map_from_body, 1e-12));
}

TEST(Scenario, surfaces_keep_off_the_borders_of_cells) {
  for (const std::string& name : scene_names()) {
    if (name == "tilted_room") continue;
    SCOPED_TRACE(name);
    const Scene scene = make_scene(name).scene;
    for (const SceneObject& object : scene.objects()) {
      const auto* cuboid = std::get_if<CuboidShape>(&object.shape);
      if (cuboid == nullptr) continue;
      const Vector3d corner = object.map_from_object.translation() - cuboid->size / 2;
      for (const double border : corner) {
        const double centimetres = (border - kOff) * 100;
        EXPECT_NEAR(centimetres, std::round(centimetres), 1e-9) << object.name;
      }
    }
  }
}

TEST(Scenario, box_and_sphere_have_the_sizes_they_say) {
  const Scene box = make_scene("box").scene;
  EXPECT_NEAR(range(box, {5, 0, 0}, {-1, 0, 0}), 4, 1e-12);
  EXPECT_NEAR(range(box, {0, -5, 0}, {0, 1, 0}), 4.4, 1e-12);
  EXPECT_NEAR(range(box, {0, 0, 5}, {0, 0, -1}), 4.6, 1e-12);
  const Scene sphere = make_scene("sphere").scene;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d unit = Vector3d::Unit(axis);
    EXPECT_NEAR(range(sphere, 3 * unit, -unit), 2, 1e-12);
  }
  EXPECT_EQ(make_scene("box").trajectory.size(), 24u);
}

TEST(Scenario, the_room_has_its_walls_and_eleven_pieces_of_furniture) {
  const Scenario room = make_scene("room");
  EXPECT_EQ(room.scene.objects().size(), 12u);
  EXPECT_NEAR(range(room.scene, {0, 0, 2.5}, {1, 0, 0}), 3, 1e-12);
  EXPECT_NEAR(range(room.scene, {0, 0, 2.5}, {0, -1, 0}), 2.5, 1e-12);
  EXPECT_NEAR(range(room.scene, {0, 0, 2}, {0, 0, 1}), 0.7, 1e-12);
  EXPECT_NEAR(range(room.scene, {0, 0, 2}, {0, 0, -1}), 2, 1e-12);
  EXPECT_NEAR(range(room.scene, {-2, -2, 2}, {0, 0, -1}), 1.5, 1e-12) << "the bed";
  EXPECT_EQ(room.sensor.noise, 0);
  EXPECT_EQ(make_scene("noisy_room").sensor.noise, 0.01);
}

TEST(Scenario, furniture_does_not_overlap_and_stands_on_the_floor) {
  const Scene scene = make_scene("room").scene;
  std::vector<Box> boxes;
  for (std::size_t i = 1; i < scene.objects().size(); ++i) {
    const auto& cuboid = std::get<CuboidShape>(scene.objects()[i].shape);
    const Vector3d center = scene.objects()[i].map_from_object.translation();
    boxes.push_back({.min = center - cuboid.size / 2, .max = center + cuboid.size / 2});
    EXPECT_NEAR(boxes.back().min.z(), kOff, 1e-12);
    for (std::size_t k = 0; k + 1 < boxes.size(); ++k) {
      const Box& other = boxes[k];
      EXPECT_TRUE((boxes.back().min.array() > other.max.array() - 1e-9).any() ||
                  (boxes.back().max.array() < other.min.array() + 1e-9).any())
          << scene.objects()[i].name << " and " << scene.objects()[k + 1].name;
    }
  }
}

TEST(Scenario, the_tilted_room_is_the_room_turned_with_its_robot) {
  const Scenario room = make_scene("room");
  const Scenario tilted = make_scene("tilted_room");
  constexpr double kDegree = std::numbers::pi / 180;
  Pose turn = Pose::Identity();
  turn.rotate(Eigen::AngleAxisd(30 * kDegree, Vector3d::UnitZ()));
  turn.rotate(Eigen::AngleAxisd(8 * kDegree, Vector3d::UnitY()));
  turn.rotate(Eigen::AngleAxisd(-5 * kDegree, Vector3d::UnitX()));
  ASSERT_EQ(tilted.scene.objects().size(), room.scene.objects().size());
  ASSERT_EQ(tilted.trajectory.size(), room.trajectory.size());
  for (std::size_t i = 0; i < room.scene.objects().size(); ++i) {
    EXPECT_TRUE(tilted.scene.objects()[i].map_from_object.isApprox(
        turn * room.scene.objects()[i].map_from_object, 1e-12));
  }
  int points = 0;
  int beside = 0;
  for (std::size_t i = 0; i < room.trajectory.size(); ++i) {
    const Pose& pose = room.trajectory[i].map_from_body;
    EXPECT_TRUE(tilted.trajectory[i].map_from_body.isApprox(turn * pose, 1e-12));
    const SpinningLidar lidar{.channels = 8, .azimuth_steps = 64, .min_range = 0.1};
    const Scan straight = simulate_scan(room.scene, {.model = lidar}, pose, 0, i);
    const Scan turned =
        simulate_scan(tilted.scene, {.model = lidar}, tilted.trajectory[i].map_from_body, 0, i);
    ASSERT_EQ(straight.points.size(), turned.points.size());
    for (std::size_t k = 0; k < straight.points.size(); ++k) {
      if ((straight.points[k] - turned.points[k]).norm() > 2e-6) ++beside;
      ++points;
    }
  }
  EXPECT_EQ(points, 12 * 8 * 64);
  EXPECT_LE(beside, 3) << "only beams that meet an edge within rounding may go past it";
}

TEST(Scenario, the_stairs_have_eight_steps_and_a_landing) {
  const Scenario stairs = make_scene("stairs");
  EXPECT_EQ(count_named(stairs.scene, "step"), 8);
  for (int step = 1; step <= 8; ++step) {
    const double middle = (step - 0.5) * 0.28;
    EXPECT_NEAR(range(stairs.scene, {middle, 0, 4}, {0, 0, -1}), 4 - 0.17 * step, 1e-12);
    // The riser, seen from before the stairs.
    EXPECT_NEAR(range(stairs.scene, {-2, 0, (step - 0.5) * 0.17}, {1, 0, 0}), 2 + (step - 1) * 0.28,
                1e-12);
  }
  EXPECT_NEAR(range(stairs.scene, {3, 0, 4}, {0, 0, -1}), 4 - 1.36, 1e-12);
  EXPECT_NEAR(range(stairs.scene, {-1, 0, 4}, {0, 0, -1}), 4, 1e-12);
}

TEST(Scenario, street_and_campus_have_what_they_say) {
  const Scenario street = make_scene("street");
  EXPECT_EQ(count_named(street.scene, "building"), 14);
  EXPECT_EQ(count_named(street.scene, "pole"), 16);
  EXPECT_EQ(count_named(street.scene, "trunk"), 18);
  EXPECT_EQ(count_named(street.scene, "crown"), 18);
  EXPECT_EQ(count_named(street.scene, "cabin"), 21);
  EXPECT_EQ(street.trajectory.size(), 20u);
  EXPECT_EQ(beam_directions(street.sensor.model, 0).size(), 115200u);

  const Scenario campus = make_scene("campus");
  EXPECT_EQ(count_named(campus.scene, "building"), 13);
  EXPECT_EQ(count_named(campus.scene, "crown"), 36);
  EXPECT_EQ(count_named(campus.scene, "pole"), 14);
  ASSERT_EQ(campus.trajectory.size(), 70u);
  double length = 0;
  for (std::size_t i = 0; i < 70; ++i) {
    length += (campus.trajectory[(i + 1) % 70].map_from_body.translation() -
               campus.trajectory[i].map_from_body.translation())
                  .norm();
  }
  EXPECT_GT(length, 235) << "a loop of 240 m, its corners cut by the steps";
  EXPECT_LT(length, 240);
}

TEST(Scenario, the_cart_drives_through_the_early_scans_and_then_is_gone) {
  const Scenario moving = make_scene("moving");
  ASSERT_EQ(moving.trajectory.size(), 30u);
  Scene still("still");
  const SceneObject* cart = nullptr;
  for (const SceneObject& object : moving.scene.objects()) {
    if (object.name == "cart") {
      cart = &object;
    } else {
      EXPECT_TRUE(is_static(object)) << object.name;
      still.add(object);
    }
  }
  ASSERT_NE(cart, nullptr);
  Vector3d last = Vector3d::Zero();
  for (std::size_t i = 0; i < moving.trajectory.size(); ++i) {
    const auto& [time, pose] = moving.trajectory[i];
    const Scan scan = simulate_scan(moving.scene, moving.sensor, pose, time, i);
    int on_cart = 0;
    Vector3d middle = Vector3d::Zero();
    for (const Vector3f& point : scan.points) {
      const Vector3d place = transformed(pose, point);
      if (still.distance_to_surface(place) < 1e-5) continue;
      ++on_cart;
      middle += place;
    }
    if (i < 10) {
      EXPECT_GT(on_cart, 50) << i;
      middle /= on_cart;
      if (i > 0) {
        EXPECT_GT((middle - last).norm(), 0.5) << i;
      }
      last = middle;
    } else {
      EXPECT_EQ(on_cart, 0) << i;
    }
  }
}

}  // namespace
}  // namespace rmap
