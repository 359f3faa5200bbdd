#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rmap/pose.hpp>
#include <rmap/simulation/scene.hpp>
#include <rmap/simulation/sensor.hpp>

namespace rmap {

/// Where a robot is at one time.
struct TimedPose {
  double time = 0;                        ///< seconds
  Pose map_from_body = Pose::Identity();  ///< body: x forward, y left, z up
};

/// A scene with a robot in it.
struct Scenario {
  std::string description;            ///< one sentence: what there is, and what a map must show
  Scene scene;                        ///< its name is the scenario's
  std::vector<TimedPose> trajectory;  ///< one pose a scan, times rising from 0
  Sensor sensor;                      ///< the sensor that suits the scene
};

struct ScenarioOptions {
  /// Number of poses, spread evenly over the same way and the same time; at most
  /// 1,000,000. 0: the scene's own.
  int scans = 0;
};

/// Names of the scenes that make_scene knows, in a fixed order.
std::vector<std::string> scene_names();

/// A scene by name, with its robot and its sensor. Metres; surfaces of the
/// axis-aligned scenes lie on whole centimetres plus 0.0033, so that none falls on
/// a border of cells at a usual resolution, and the origin is shifted as much.
///
/// - `box`: a box of 2 x 1.2 x 0.8 centred at the origin, nothing else. 24 views
///   from all around at a distance of 4, depth camera.
/// - `sphere`: a sphere of radius 1 around the origin, nothing else. The same views.
/// - `room`: 6 x 5 x 2.7, the origin in the middle of its floor; 11 boxes of
///   furniture stand on the floor. A loop of 12 scans at a height of 1.3, wide lidar.
/// - `noisy_room`: the room, measured with a noise of 0.01.
/// - `tilted_room`: the room and the robot in it turned about the map's origin by
///   yaw 30, then pitch 8, then roll -5 degrees.
/// - `stairs`: 8 steps up along x from the origin, rise 0.17, tread 0.28, width 1.4,
///   to a landing at 1.36; level ground around. 16 scans from before the stairs up to
///   the landing, wide lidar.
/// - `street`: along x from -60 to 60; ground, 14 buildings on both sides, 16 poles,
///   18 trees, 21 parked cars. 20 scans from x = -30 to 30, 64-channel lidar.
/// - `campus`: ground of 160 x 120, 13 buildings, 36 trees, 14 poles. A loop of 240
///   with 70 scans, 32-channel lidar that sees up to 50.
/// - `moving`: a walled yard of 16 x 12, in which a cart of 0.8 x 0.8 x 1.6 drives for
///   10 s and then is gone: only the static surface may be left in a map. 30 scans in
///   29 s, wide lidar.
///
/// Throws Error(input) that lists the names when there is no such scene, or names
/// `scans` when it is out of range.
Scenario make_scene(std::string_view name, const ScenarioOptions& options = {});

}  // namespace rmap
