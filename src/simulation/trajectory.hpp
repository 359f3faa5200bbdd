#pragma once

#include <vector>

#include <rmap/simulation/scenario.hpp>

namespace rmap::simulation {

/// `count` poses evenly spread along the polyline, both ends included, in
/// `duration` seconds; level, looking along it. One pose is its start.
std::vector<TimedPose> along_path(const std::vector<Vector3d>& corners, int count, double duration);

/// The same around a closed polyline, whose last corner leads back to the first;
/// the next pose would be the first again.
std::vector<TimedPose> around_loop(std::vector<Vector3d> corners, int count, double duration);

/// `count` poses evenly spread over a sphere around the origin, from the top
/// down, one a second, looking at its centre.
std::vector<TimedPose> all_around(double radius, int count);

}  // namespace rmap::simulation
