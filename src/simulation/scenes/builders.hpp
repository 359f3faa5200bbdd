#pragma once

#include <rmap/simulation/scenario.hpp>

// The scenes by name, each as documented at make_scene; `scans` 0 means the
// scene's own number. They are built on whole centimetres: make_scene shifts them.
namespace rmap::simulation {

Scenario build_box(int scans);
Scenario build_sphere(int scans);
Scenario build_room(int scans);
Scenario build_noisy_room(int scans);
Scenario build_stairs(int scans);
Scenario build_street(int scans);
Scenario build_campus(int scans);
Scenario build_moving(int scans);

}  // namespace rmap::simulation
