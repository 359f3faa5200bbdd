#pragma once

#include <span>
#include <vector>

#include <rmap/box.hpp>

namespace rmap {

/// The normal of a flat patch of a cloud.
struct PatchNormal {
  Vector3d direction;  ///< of length 1, either way
  double weight = 0;   ///< 1 for a perfect plane, towards 0 for what is hardly flat
};

/// Normals of the cloud in cubes of 4 cells, or of 8 or 16 where few of those are flat.
std::vector<PatchNormal> patch_normals(std::span<const Vector3f> points, double resolution);

}  // namespace rmap
