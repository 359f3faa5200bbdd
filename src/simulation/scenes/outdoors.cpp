#include "simulation/scenes/builders.hpp"
#include "simulation/scenes/parts.hpp"
#include "simulation/trajectory.hpp"

namespace rmap::simulation {

namespace {

struct Building {
  double min_x;
  double min_y;
  double max_x;
  double max_y;
  double height;
};

void add_buildings(Scene& scene, const std::vector<Building>& buildings) {
  for (const Building& building : buildings) {
    scene.add(box_between("building " + std::to_string(scene.objects().size()),
                          {building.min_x, building.min_y, 0},
                          {building.max_x, building.max_y, building.height}));
  }
}

std::string numbered(const char* name, int number) {
  return std::string(name) + " " + std::to_string(number);
}

}  // namespace

Scenario build_street(int scans) {
  Scene scene("street");
  add_ground(scene, {-60, -25, 0}, {60, 25, 0});
  add_buildings(scene, {{-58, 9, -44, 20, 9},
                        {-43, 9.5, -30, 21, 12},
                        {-27, 9, -13, 19, 7.5},
                        {-12.5, 10, 4, 22, 15},
                        {7, 9, 20, 20, 10},
                        {21, 9.5, 38, 21, 8},
                        {40, 9, 57, 20, 13},
                        {-59, -20, -41, -9, 11},
                        {-38, -21, -25, -9.5, 8},
                        {-24, -20, -8, -9, 14},
                        {-4, -19, 11, -9, 9},
                        {12, -22, 27, -10, 12},
                        {30, -20, 43, -9, 7},
                        {44, -20, 58, -9.5, 10}});
  int number = 0;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < 8; ++i) {
      add_pole(scene, numbered("pole", ++number), -52.5 + 15 * i, side * 5.2, 6);
    }
    for (int i = 0; i < 9; ++i) {
      add_tree(scene, numbered("tree", ++number), -50 + 12 * i, side * 6.9, 3.5 + 0.25 * (i % 4),
               1.2 + 0.2 * (i % 3));
    }
  }
  // Gaps of several lengths between the parked cars.
  for (const double x : {-47.0, -41.5, -30.0, -24.5, -19.0, -3.0, 2.5, 14.0, 27.5, 33.0, 45.0}) {
    add_car(scene, numbered("car", ++number), x, 3.8);
  }
  for (const double x : {-50.0, -36.0, -30.5, -14.0, -8.5, 9.0, 20.0, 25.5, 38.0, 43.5}) {
    add_car(scene, numbered("car", ++number), x, -3.8);
  }
  return {
      .description =
          "a street of 120 m: ground, buildings on both sides, poles, trees, parked cars",
      .scene = std::move(scene),
      .trajectory = along_path({{-30, -1.5, 1.8}, {30, -1.5, 1.8}}, scans == 0 ? 20 : scans, 19),
      .sensor = {.model = make_sensor("lidar64")}};
}

Scenario build_campus(int scans) {
  Scene scene("campus");
  add_ground(scene, {-80, -60, 0}, {80, 60, 0});
  add_buildings(scene, {{-32, -11, -14, 12, 12},
                        {-8, -12, 9, 7, 9},
                        {16, -10, 33, 13, 14},
                        {-70, -52, -44, -34, 10},
                        {-36, -54, -8, -30, 15},
                        {0, -50, 30, -32, 8},
                        {40, -53, 68, -33, 12},
                        {-71, 31, -46, 55, 13},
                        {-38, 33, -12, 52, 9},
                        {-4, 30, 24, 54, 16},
                        {34, 34, 66, 53, 10},
                        {-76, -22, -55, 20, 7},
                        {54, -24, 74, 22, 11}});
  int number = 0;
  for (const double side : {-1.0, 1.0}) {
    for (int i = 0; i < 12; ++i) {
      add_tree(scene, numbered("tree", ++number), -44 + 8 * i, side * 25.5, 4 + 0.5 * (i % 3),
               1.6 + 0.3 * (i % 4));
    }
    for (int i = 0; i < 6; ++i) {
      add_tree(scene, numbered("tree", ++number), side * 46, -17.5 + 7 * i, 4.5, 1.8);
    }
    for (int i = 0; i < 7; ++i) {
      add_pole(scene, numbered("pole", ++number), -36 + 12 * i, side * 17, 5);
    }
  }
  return {
      .description = "a loop of 240 m between buildings and trees",
      .scene = std::move(scene),
      .trajectory = around_loop({{-40, -20, 1.6}, {40, -20, 1.6}, {40, 20, 1.6}, {-40, 20, 1.6}},
                                scans == 0 ? 70 : scans, 210),
      .sensor = {.model = SpinningLidar{.channels = 32,
                                        .min_elevation = -25,
                                        .max_elevation = 15,
                                        .azimuth_steps = 1024,
                                        .min_range = 0.5,
                                        .max_range = 50}}};
}

Scenario build_moving(int scans) {
  Scene scene("moving");
  add_ground(scene, {-9, -7, 0}, {9, 7, 0});
  scene.add(box_between("west wall", {-8.2, -6.2, 0}, {-8, 6.2, 2.5}));
  scene.add(box_between("east wall", {8, -6.2, 0}, {8.2, 6.2, 2.5}));
  scene.add(box_between("south wall", {-8, -6.2, 0}, {8, -6, 2.5}));
  scene.add(box_between("north wall", {-8, 6, 0}, {8, 6.2, 2.5}));
  scene.add(box_between("shed", {-7.5, 3, 0}, {-5, 5.5, 2.2}));
  scene.add(box_between("bench", {5.5, 4.8, 0}, {7.5, 5.4, 0.5}));
  add_tree(scene, "tree", -5.5, -4, 3, 1.2);

  SceneObject cart = box_between("cart", {-0.4, -0.4, 0}, {0.4, 0.4, 1.6});
  cart.motion = {{.time = 0, .translation = {-4, 2, 0}},
                 {.time = 5, .translation = {4, 2, 0}},
                 {.time = 10, .translation = {4, -3, 0}}};
  cart.visible_until = 10;
  scene.add(std::move(cart));
  return {
      .description = "a walled yard of 16 x 12 m in which a cart drives for 10 s and then is gone",
      .scene = std::move(scene),
      .trajectory = along_path({{-6, -0.5, 1.2}, {6, -0.5, 1.2}}, scans == 0 ? 30 : scans, 29),
      .sensor = {.model = make_sensor("wide_lidar")}};
}

}  // namespace rmap::simulation
