#include "approximation/patch_normals.hpp"

#include "grid/cell_places.hpp"

#include <algorithm>
#include <cstdint>

#include <Eigen/Eigenvalues>

#include <rmap/lattice.hpp>

namespace rmap {

namespace {

/// Sums over the points of a cube, from its first point on.
struct Patch {
  Cell cube;
  Vector3d first;
  std::uint64_t count = 0;
  Vector3d sum = Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
};

std::vector<Patch> patches_of(std::span<const Vector3f> points, double edge) {
  constexpr double kLargestEdge = 1e6;  // that a lattice has
  const Lattice lattice(std::min(edge, kLargestEdge));
  std::vector<Patch> patches;
  CellPlaces places;
  for (const Vector3f& point : points) {
    const Vector3d at = point.cast<double>();
    const auto cube = lattice.find_cell(at);
    if (!cube) continue;
    const std::uint32_t place =
        places.add(*cube, CellPlaces::hash_of(*cube),
                   [&](std::uint32_t i) -> const Cell& { return patches[i].cube; });
    if (place == patches.size()) patches.push_back({.cube = *cube, .first = at});
    Patch& patch = patches[place];
    const Vector3d offset = at - patch.first;
    ++patch.count;
    patch.sum += offset;
    patch.squares += offset * offset.transpose();
  }
  return patches;
}

/// Whether a patch is flat but no line: then its normal.
bool find_normal(const Patch& patch, PatchNormal& normal) {
  constexpr double kFlat = 0.12;
  const double count = static_cast<double>(patch.count);
  const Vector3d mean = patch.sum / count;
  const Eigen::Matrix3d covariance = patch.squares / count - mean * mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Vector3d& spread = solver.eigenvalues();
  if (!(spread[1] > 0) || spread[0] > kFlat * spread[1] || spread[1] < kFlat * spread[2]) {
    return false;
  }
  normal.direction = solver.eigenvectors().col(0);
  normal.weight = 1 - std::max(spread[0], 0.0) / (kFlat * spread[1]);
  return true;
}

}  // namespace

std::vector<PatchNormal> patch_normals(std::span<const Vector3f> points, double resolution) {
  constexpr std::uint64_t kFewestPoints = 8;
  constexpr std::size_t kFewestPatches = 150;
  constexpr double kFewestFlat = 0.4;
  std::vector<PatchNormal> normals;
  for (const double cells : {4.0, 8.0, 16.0}) {
    normals.clear();
    std::size_t asked = 0;
    for (const Patch& patch : patches_of(points, cells * resolution)) {
      if (patch.count < kFewestPoints) continue;
      ++asked;
      PatchNormal normal;
      if (find_normal(patch, normal)) normals.push_back(normal);
    }
    if (normals.size() >= kFewestPatches &&
        static_cast<double>(normals.size()) >= kFewestFlat * static_cast<double>(asked)) {
      break;
    }
  }
  return normals;
}

}  // namespace rmap
