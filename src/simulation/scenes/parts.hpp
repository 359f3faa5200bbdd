#pragma once

#include <string>

#include <rmap/simulation/scene.hpp>

// What the scenes are made of. Everything stands on the ground, z = 0; metres.
namespace rmap::simulation {

/// The axis-aligned box from `min` to `max`.
SceneObject box_between(std::string name, const Vector3d& min, const Vector3d& max,
                        Side seen_from = Side::outside);

void add_ground(Scene& scene, const Vector3d& min, const Vector3d& max);
void add_pole(Scene& scene, const std::string& name, double x, double y, double height);
/// A trunk of radius 0.2 with a sphere for a crown, whose middle is at `height`.
void add_tree(Scene& scene, const std::string& name, double x, double y, double height,
              double crown_radius);
/// A car parked along x, its middle at (x, y): a body with a cabin on top, 4.2 x 1.8 x 1.5.
void add_car(Scene& scene, const std::string& name, double x, double y);

}  // namespace rmap::simulation
