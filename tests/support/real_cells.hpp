#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rmap/counted_cells.hpp>

namespace rmap::test {

/// Cells that cuboids are measured on.
struct CellScene {
  std::string name;
  double resolution = 0;  ///< metres
  std::vector<CountedCell> cells = {};
};

/// The names of the scenes from real data: office, fr_079 and fr_campus (OctoMap's maps), street
/// and hall (all scans of a sequence merged at 0.1 m), bunny (its surface sampled a million times,
/// cells of a 200th of its length).
const std::vector<std::string>& cell_scene_names();

/// A scene by its name; without cells when its file is missing.
CellScene real_cell_scene(const std::string& name);

/// Points on the surface of a room of 6 x 5 x 2.7 m with 11 boxes of furniture, `density` of them a
/// square metre, with noise across the surface (m). Its walls stand in the middle of cells of 5 cm.
std::vector<Vector3f> room_points(double density, double noise, std::uint64_t seed = 7);

/// The same on three sides of a corner alone: the floor, and the two walls that meet there.
std::vector<Vector3f> wall_points(int walls, double density, double noise, std::uint64_t seed = 7);

}  // namespace rmap::test
