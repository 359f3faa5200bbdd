#include "approximation/cell_blocks.hpp"
#include "approximation/coordinate_entropy.hpp"
#include "approximation/cover_tiles.hpp"
#include "approximation/patch_normals.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <Eigen/SVD>
#include <fmt/format.h>

#include <rmap/approximate.hpp>
#include <rmap/counted_cells.hpp>
#include <rmap/cuboid_frame.hpp>

namespace rmap {

namespace {

using Eigen::Matrix3d;

constexpr double kDegree = std::numbers::pi / 180;

/// Rows are the axes of the new frame.
Matrix3d nearest_rotation(const Matrix3d& matrix) {
  const Eigen::JacobiSVD<Matrix3d> svd(matrix, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
  if (rotation.determinant() < 0) {
    Matrix3d u = svd.matrixU();
    u.col(2) *= -1;
    rotation = u * svd.matrixV().transpose();
  }
  return rotation;
}

Matrix3d turn(const Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

double angle_of(const Matrix3d& rotation) { return Eigen::AngleAxisd(rotation).angle(); }

/// How well axes agree with normals: each counts by its angle to the nearest axis, up to 8 degrees.
double agreement(const Matrix3d& axes, std::span<const PatchNormal> normals) {
  const double range = 1 - std::cos(8 * kDegree);
  double sum = 0;
  for (const PatchNormal& normal : normals) {
    const double nearest = (axes * normal.direction).cwiseAbs().maxCoeff();
    sum += normal.weight * std::max(0.0, 1 - (1 - nearest) / range);
  }
  return sum;
}

/// The axes of the pair of normals that most others agree with.
Matrix3d first_guess(std::span<const PatchNormal> normals) {
  constexpr double kLeadOfIdentity = 1.02;
  constexpr int kFirsts = 60;
  constexpr int kSeconds = 12;
  Matrix3d best = Matrix3d::Identity();
  if (normals.empty()) return best;
  double most = kLeadOfIdentity * agreement(best, normals);
  std::mt19937 random;
  const auto any = [&] { return normals[random() % normals.size()].direction; };
  for (int i = 0; i < kFirsts; ++i) {
    const Vector3d first = any();
    for (int j = 0; j < kSeconds; ++j) {
      const Vector3d across = first.cross(any());
      if (across.norm() < 0.5) continue;  // hardly two directions
      Matrix3d axes;
      axes.row(0) = first.transpose();
      axes.row(1) = across.normalized().transpose();
      axes.row(2) = first.cross(across.normalized()).transpose();
      const double sum = agreement(axes, normals);
      if (sum > most) {
        most = sum;
        best = axes;
      }
    }
  }
  return best;
}

/// Turns axes to the mean of the normals near them, nearer ones each time.
Matrix3d refined(Matrix3d axes, std::span<const PatchNormal> normals) {
  constexpr double kOfBefore = 1e-6;  // decides where no normal does
  for (const double degrees : {15, 10, 7, 5, 4, 3, 3, 3}) {
    const double nearest = std::cos(degrees * kDegree);
    Matrix3d sum = kOfBefore * axes;
    for (const PatchNormal& normal : normals) {
      const Vector3d along = axes * normal.direction;
      int axis = 0;
      if (along.cwiseAbs().maxCoeff(&axis) < nearest) continue;
      const double sign = along[axis] < 0 ? -1 : 1;
      sum.row(axis) += sign * normal.weight * normal.direction.transpose();
    }
    axes = nearest_rotation(sum);
  }
  return axes;
}

/// Turns axes about each of them, by smaller and smaller angles, to where coordinates crowd most.
Matrix3d descended(Matrix3d axes, const CoordinateEntropy& entropy, double bin) {
  double least = entropy.of(axes, bin);
  constexpr int kHalvings = 6;  // from 0.4 to 0.0125 degrees
  double step = 0.4 * kDegree;
  for (int halving = 0; halving < kHalvings; ++halving, step /= 2) {
    for (bool better = true; better;) {
      better = false;
      for (int axis = 0; axis < 3; ++axis) {
        for (const double sign : {1.0, -1.0}) {
          const Matrix3d turned = turn(Vector3d::Unit(axis), sign * step) * axes;
          const double now = entropy.of(turned, bin);
          if (now < least) {
            least = now;
            axes = turned;
            better = true;
          }
        }
      }
    }
  }
  return axes;
}

/// The two angles about an axis, in whole degrees, at which coordinates crowd most.
std::array<double, 2> best_turns(const Matrix3d& axes, int axis, const CoordinateEntropy& entropy,
                                 double bin) {
  std::array<double, 90> at;
  for (std::size_t degrees = 0; degrees < at.size(); ++degrees) {
    const double angle = static_cast<double>(degrees) * kDegree;
    at[degrees] = entropy.of(turn(Vector3d::Unit(axis), angle) * axes, bin);
  }
  const auto first = std::min_element(at.begin(), at.end());
  const auto best = static_cast<std::size_t>(first - at.begin());
  std::size_t second = (best + 45) % at.size();
  for (std::size_t degrees = 0; degrees < at.size(); ++degrees) {
    const std::size_t apart = (degrees + at.size() - best) % at.size();
    if (apart < 3 || apart > at.size() - 3) continue;  // the same one
    if (at[degrees] < at[second]) second = degrees;
  }
  return {static_cast<double>(best) * kDegree, static_cast<double>(second) * kDegree};
}

int best_supported(const Matrix3d& axes, std::span<const PatchNormal> normals) {
  Vector3d support = Vector3d::Zero();
  for (const PatchNormal& normal : normals) {
    const Vector3d along = (axes * normal.direction).cwiseAbs();
    for (int axis = 0; axis < 3; ++axis) {
      if (along[axis] > std::cos(5 * kDegree)) support[axis] += normal.weight;
    }
  }
  int axis = 2;
  support.maxCoeff(&axis);
  return axis;
}

/// Of the rotations that take these axes, in any order and direction, to x, y and z, the smallest.
Matrix3d nearest_to_identity(const Matrix3d& axes) {
  Matrix3d best = axes;
  double least = std::numeric_limits<double>::infinity();
  std::array<int, 3> order{0, 1, 2};
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Matrix3d other;
      for (int axis = 0; axis < 3; ++axis) {
        const double sign = ((signs >> axis) & 1) != 0 ? -1 : 1;
        other.row(axis) = sign * axes.row(order[static_cast<std::size_t>(axis)]);
      }
      if (other.determinant() < 0) continue;
      if (const double angle = angle_of(other); angle < least) {
        least = angle;
        best = other;
      }
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return best;
}

/// Those that have a cell however they are turned about the origin.
std::vector<Vector3f> sorted_points(std::span<const Vector3f> points, const Lattice& lattice) {
  const double reach = lattice.resolution() * kMaxCellIndex;
  std::vector<Vector3f> sorted;
  sorted.reserve(points.size());
  std::copy_if(points.begin(), points.end(), std::back_inserter(sorted),
               [&](const Vector3f& point) { return point.cast<double>().norm() < reach; });
  std::sort(sorted.begin(), sorted.end(), [](const Vector3f& a, const Vector3f& b) {
    return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
  });
  return sorted;
}

Matrix3d most_crowded_axes(std::span<const Vector3f> points, double resolution) {
  constexpr std::size_t kPoints = 60000;
  constexpr std::size_t kFewPoints = 12000;
  constexpr double kWorthATurn = 0.02;
  const std::vector<PatchNormal> normals = patch_normals(points, resolution);
  const CoordinateEntropy entropy(points, kPoints);
  const double bin = resolution / 2;
  Matrix3d axes = descended(refined(first_guess(normals), normals), entropy, bin);
  // Where only floors have spoken, walls are found by turning about their normal.
  const int axis = best_supported(axes, normals);
  const CoordinateEntropy rough(points, kFewPoints);
  double least = entropy.of(axes, bin);
  const Matrix3d before = axes;
  for (const double angle : best_turns(before, axis, rough, resolution)) {
    const Matrix3d turned = descended(turn(Vector3d::Unit(axis), angle) * before, entropy, bin);
    if (const double now = entropy.of(turned, bin); now < least - kWorthATurn) {
      least = now;
      axes = turned;
    }
  }
  return nearest_to_identity(axes);
}

/// Cuboids for the cells in a frame; without those of a lone cell, which are as many in any frame
/// and would drown the others where outliers are many.
std::size_t trial(std::span<const Vector3f> points, const Pose& frame,
                  const FrameOptions& options) {
  const Lattice lattice(options.resolution);
  const CellBlocks cells(quantize(points, lattice, frame).cells);
  const std::vector<CellBox> boxes =
      cover_by_tiles(cells, {.outer = options.outer, .reshape = false}, options.threads);
  return static_cast<std::size_t>(std::count_if(
      boxes.begin(), boxes.end(), [&](const CellBox& box) { return cells.count(box) > 1; }));
}

}  // namespace

FrameEstimate estimate_frame(std::span<const Vector3f> all, const FrameOptions& options) {
  constexpr double kLeastGain = 0.3;
  constexpr double kLeastAngle = 0.1 * kDegree;
  constexpr double kWorthIt = 0.9;
  // A gain that speaks for itself: cuboids for many outliers would hide it in a trial.
  constexpr double kClearGain = 1;
  const Lattice lattice(options.resolution);
  // Checked by the rules of the approximation that is to come.
  approximate({}, {.outer = options.outer, .threads = options.threads});
  const std::vector<Vector3f> points = sorted_points(all, lattice);
  FrameEstimate estimate;
  if (points.empty()) {
    estimate.why = "there are no points within the limits";
    return estimate;
  }
  const Matrix3d axes = most_crowded_axes(points, lattice.resolution());
  const CoordinateEntropy entropy(points, points.size());
  const double bin = lattice.resolution() / 2;
  estimate.entropy_gain = entropy.of(Matrix3d::Identity(), bin) - entropy.of(axes, bin);
  if (estimate.entropy_gain < kLeastGain) {
    estimate.why = "no other axes crowd the coordinates clearly more";
    return estimate;
  }
  if (angle_of(axes) < kLeastAngle) {
    estimate.why = "the cloud lies along the axes";
    return estimate;
  }
  Pose frame = Pose::Identity();
  frame.linear() = axes;
  const auto now = static_cast<double>(trial(points, Pose::Identity(), options));
  const auto then = static_cast<double>(trial(points, frame, options));
  estimate.cuboid_ratio = now == 0 ? 1 : then / now;
  if (estimate.cuboid_ratio > kWorthIt && estimate.entropy_gain < kClearGain) {
    estimate.why =
        fmt::format("a trial in other axes needs {:.2f} times the cuboids", estimate.cuboid_ratio);
    return estimate;
  }
  estimate.frame = frame;
  estimate.identity = false;
  estimate.why =
      fmt::format("turned by {:.2f} degrees, where a trial needs {:.2f} times the cuboids",
                  angle_of(axes) / kDegree, estimate.cuboid_ratio);
  return estimate;
}

Vector3d phase_shift(std::span<const Vector3f> points, const Pose& frame, double resolution,
                     CuboidPhase phase) {
  const Lattice lattice(resolution);
  Vector3d shift = Vector3d::Zero();
  if (phase == CuboidPhase::zero || points.empty()) return shift;
  // Where walls are, coordinates fill few cells to the full.
  constexpr int kOffsets = 16;
  for (int axis = 0; axis < 3; ++axis) {
    double most = -1;
    for (int offset = 0; offset < kOffsets; ++offset) {
      const double moved = offset / static_cast<double>(kOffsets);
      const double squares = crowding(points, frame, axis, lattice, moved);
      if (squares > most) {
        most = squares;
        shift[axis] = moved * resolution;
      }
    }
  }
  return shift;
}

}  // namespace rmap
