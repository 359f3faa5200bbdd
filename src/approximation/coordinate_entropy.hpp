#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <rmap/box.hpp>
#include <rmap/lattice.hpp>
#include <rmap/pose.hpp>

namespace rmap {

/// How evenly the coordinates of a cloud are spread on axes: the sum over three axes of the
/// entropy (nats) of a histogram. Low where planes of the cloud lie across an axis.
class CoordinateEntropy {
 public:
  /// Of every so manyth point, at most `most` of them.
  CoordinateEntropy(std::span<const Vector3f> points, std::size_t most);

  /// `axes`: a direction in each row; `bin`: of the histogram, metres. Each point counts in the
  /// two bins whose centres it lies between, so that the result is continuous.
  double of(const Eigen::Matrix3d& axes, double bin) const;

 private:
  std::vector<Vector3d> points_;
};

/// Sum of the squares of how many points lie in each layer of cells across an axis, after a shift
/// by a share of a cell.
double crowding(std::span<const Vector3f> points, const Pose& frame, int axis,
                const Lattice& lattice, double shift);

}  // namespace rmap
