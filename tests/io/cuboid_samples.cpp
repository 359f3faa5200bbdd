#include "io/cuboid_samples.hpp"

#include "io/files.hpp"

#include <algorithm>
#include <limits>

#include <rmap/cuboid_files.hpp>

namespace rmap::test {

Pose random_frame(Random& random) {
  Pose frame = Pose::Identity();
  frame.linear() = Eigen::AngleAxisd(random.real(-3, 3), random.direction()).toRotationMatrix();
  frame.translation() = random.point(-100, 100);
  return frame;
}

CuboidList near_cuboids(Random& random, int count, int extent) {
  CuboidList list{.resolution = random.real(0.01, 0.5), .frame = random_frame(random)};
  for (int i = 0; i < count; ++i) {
    list.cuboids.push_back({.cells = random.box(-extent, extent, 1 + extent / 10),
                            .points = static_cast<std::uint64_t>(random.integer(0, 100000))});
  }
  return list;
}

CuboidList random_cuboids(Random& random, int count) {
  CuboidList list = near_cuboids(random, count);
  for (Cuboid& cuboid : list.cuboids) {
    if (!random.chance(0.05)) continue;
    cuboid.points = std::numeric_limits<std::uint64_t>::max() - cuboid.points;
    if (random.chance(0.5)) cuboid.cells.max = all_cells().max;
    if (random.chance(0.5)) cuboid.cells.min = all_cells().min;
  }
  return list;
}

CuboidList small_list() {
  Pose frame = Pose::Identity();
  frame.linear() << 1, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8;
  frame.translation() << 1.5, -2.25, 0.1;
  return {.resolution = 0.1,
          .frame = frame,
          .cuboids = {{.cells = {.min = {-10, 0, 3}, .max = {20, 5, 4}}, .points = 75},
                      {.cells = box_of(Cell(7, -1, 0)), .points = 0}}};
}

bool same(const CuboidList& a, const CuboidList& b) {
  return a.resolution == b.resolution && a.frame.matrix() == b.frame.matrix() &&
         a.cuboids == b.cuboids;
}

Corners corners_of(const CuboidList& list, const Cuboid& cuboid) {
  Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Vector3d corner;
    for (int axis = 0; axis < 3; ++axis) {
      const bool at_max = ((i >> axis) & 1U) != 0;
      corner[axis] = list.resolution * (at_max ? cuboid.cells.max : cuboid.cells.min)[axis];
    }
    corners[i] = list.frame.inverse() * corner;
  }
  return corners;
}

Corners corners_of(const Vector3d& center, const Eigen::Matrix3d& rotation, const Vector3d& size) {
  Corners corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    Vector3d half = size / 2;
    for (int axis = 0; axis < 3; ++axis) {
      if (((i >> axis) & 1U) == 0) half[axis] = -half[axis];
    }
    corners[i] = center + rotation * half;
  }
  return corners;
}

double distance(const Corners& a, const Corners& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

std::string written(const std::string& ending, const CuboidList& list) {
  const TemporaryFolder folder;
  write_cuboids(folder / ("a" + ending), list);
  return read_text(folder / ("a" + ending));
}

}  // namespace rmap::test
