#pragma once

#include "support/plain_grid.hpp"

#include <set>

#include <octomap/octomap.h>

#include <rmap/scan.hpp>

namespace rmap::test {

/// The scan with its points as float32 in the map's frame, its origin rounded to
/// float32 as well: what OctoMap is given, so that both get the same numbers.
inline Scan in_map_frame(const Scan& scan) {
  Scan moved{.frame = Frame::map};
  moved.map_from_sensor.translation() =
      Vector3d(scan.map_from_sensor.translation()).cast<float>().cast<double>();
  for (const Vector3f& point : scan.points) {
    moved.points.push_back(transformed(scan.map_from_sensor, point).cast<float>());
  }
  return moved;
}

/// A point, or a direction, as OctoMap has it.
inline octomap::point3d octomap_point(const Vector3d& vector) {
  const Vector3f rounded = vector.cast<float>();
  return {rounded.x(), rounded.y(), rounded.z()};
}

inline octomap::Pointcloud octomap_cloud(const Scan& scan) {
  octomap::Pointcloud cloud;
  cloud.reserve(scan.points.size());
  for (const Vector3f& point : scan.points) cloud.push_back(point.x(), point.y(), point.z());
  return cloud;
}

inline void insert_into(octomap::OcTree& tree, const Scan& scan) {
  tree.insertPointCloud(octomap_cloud(scan), octomap_point(scan.map_from_sensor.translation()));
}

/// The cell that a key of OctoMap names.
inline Cell cell_of(const octomap::OcTreeKey& key) {
  return {key[0] - 32768, key[1] - 32768, key[2] - 32768};
}

/// The occupied cells of an OctoMap, pruned leaves taken apart.
inline std::set<Cell, MortonOrder> occupied_cells(octomap::OcTree& tree) {
  tree.expand();
  std::set<Cell, MortonOrder> cells;
  for (auto leaf = tree.begin_leafs(); leaf != tree.end_leafs(); ++leaf) {
    if (!tree.isNodeOccupied(*leaf)) continue;
    cells.insert(cell_of(leaf.getKey()));
  }
  return cells;
}

}  // namespace rmap::test
