#include "simulation/scenes/builders.hpp"
#include "simulation/scenes/parts.hpp"
#include "simulation/trajectory.hpp"

namespace rmap::simulation {

Scenario build_room(int scans) {
  Scene scene("room");
  scene.add(box_between("walls", {-3, -2.5, 0}, {3, 2.5, 2.7}, Side::inside));
  scene.add(box_between("bed", {-3, -2.5, 0}, {-1, -1.1, 0.5}));
  scene.add(box_between("night table", {-0.9, -2.5, 0}, {-0.45, -2.1, 0.55}));
  scene.add(box_between("wardrobe", {1.4, -2.5, 0}, {3, -1.9, 2.1}));
  scene.add(box_between("desk", {2.3, -0.8, 0}, {3, 0.8, 0.74}));
  scene.add(box_between("chair", {1.65, -0.25, 0}, {2.1, 0.2, 0.95}));
  scene.add(box_between("shelf", {-3, -0.5, 0}, {-2.65, 0.7, 1.9}));
  scene.add(box_between("sofa", {-2.4, 1.6, 0}, {-0.4, 2.5, 0.8}));
  scene.add(box_between("coffee table", {-1.7, 0.7, 0}, {-0.8, 1.15, 0.42}));
  scene.add(box_between("cupboard", {0.2, 2.05, 0}, {1.4, 2.5, 1.0}));
  scene.add(box_between("crate", {2.3, 1.7, 0}, {2.9, 2.3, 0.6}));
  scene.add(box_between("stool", {0.9, -1.5, 0}, {1.3, -1.1, 0.45}));

  const double height = 1.3;
  return {.description = "a room of 6 x 5 x 2.7 m with 11 boxes of furniture",
          .scene = std::move(scene),
          .trajectory = around_loop(
              {{-1.4, -0.9, height}, {1.2, -0.9, height}, {1.2, 0.9, height}, {-1.4, 0.9, height}},
              scans == 0 ? 12 : scans, 12),
          .sensor = {.model = make_sensor("wide_lidar")}};
}

Scenario build_noisy_room(int scans) {
  Scenario room = build_room(scans);
  room.description += ", measured with a noise of 0.01 m";
  room.sensor.noise = 0.01;
  return room;
}

Scenario build_stairs(int scans) {
  constexpr int kSteps = 8;
  constexpr double kRise = 0.17;
  constexpr double kTread = 0.28;
  constexpr double kHalfWidth = 0.7;
  Scene scene("stairs");
  add_ground(scene, {-4, -3, 0}, {5, 3, 0});
  for (int i = 0; i < kSteps; ++i) {
    scene.add(box_between("step " + std::to_string(i + 1), {i * kTread, -kHalfWidth, 0},
                          {(i + 1) * kTread, kHalfWidth, (i + 1) * kRise}));
  }
  const double length = kSteps * kTread;
  const double height = kSteps * kRise;
  scene.add(box_between("landing", {length, -kHalfWidth, 0}, {length + 1.4, kHalfWidth, height}));

  const double eyes = 1.4;
  return {.description = "stairs of 8 steps, rise 0.17 m and tread 0.28 m, up to a landing",
          .scene = std::move(scene),
          .trajectory = along_path({{-2.5, 0, eyes},
                                    {0, 0, eyes},
                                    {length, 0, eyes + height},
                                    {length + 0.7, 0, eyes + height}},
                                   scans == 0 ? 16 : scans, 15),
          .sensor = {.model = make_sensor("wide_lidar")}};
}

}  // namespace rmap::simulation
