#pragma once

#include "support/random.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <rmap/cuboids.hpp>

namespace rmap::test {

/// A pose turned about all axes.
Pose random_frame(Random& random);

/// Cuboids of all sizes, some with the largest indices and counts that there are.
CuboidList random_cuboids(Random& random, int count);

/// Cuboids within `extent` cells of the origin, in a tilted frame: what meshes are compared on.
CuboidList near_cuboids(Random& random, int count, int extent = 1000);

/// One cuboid in a tilted frame, and one that is a single cell: for damage and texts.
CuboidList small_list();

/// Whether lists are the same, number for number.
bool same(const CuboidList& a, const CuboidList& b);

using Corners = std::array<Vector3d, 8>;

/// The corners of a cuboid in the input's frame; bit a of the index: at max of axis a.
Corners corners_of(const CuboidList& list, const Cuboid& cuboid);

/// The same of a box that a file describes.
Corners corners_of(const Vector3d& center, const Eigen::Matrix3d& rotation, const Vector3d& size);

/// The largest distance of a corner from its counterpart.
double distance(const Corners& a, const Corners& b);

/// What write_cuboids makes of a list.
std::string written(const std::string& ending, const CuboidList& list);

}  // namespace rmap::test
