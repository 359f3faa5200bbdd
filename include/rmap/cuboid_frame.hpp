#pragma once

#include <span>
#include <string>

#include <rmap/box.hpp>
#include <rmap/pose.hpp>

namespace rmap {

struct FrameOptions {
  /// Edge of the cells that are to come, metres.
  double resolution = 0.1;
  /// As in ApproximationOptions: what the trial allows.
  int outer = 1;
  int threads = 1;
};

/// A rotation in which a cloud lies along the axes.
struct FrameEstimate {
  /// From the cloud's frame to the estimated one: a rotation about the origin.
  Pose frame = Pose::Identity();
  bool identity = true;     ///< the cloud's own frame is kept
  std::string why;          ///< why it is kept or changed, in words
  double entropy_gain = 0;  ///< of the coordinates on the three axes, in nats
  double cuboid_ratio =
      1;  ///< cuboids of a trial, of more than a cell, against the cloud's own frame
};

/// Looks for the rotation in which walls, floors and other planes of a cloud (m) are axis aligned
/// [RMAP 4.2]: from the normals of patches, refined to where coordinates crowd most. Of the 24
/// equal rotations the one nearest to none. The cloud's own frame is kept unless a trial needs at
/// least 10 % fewer cuboids, or the entropy falls by 1 nat and more, which many outliers do not
/// hide. The order of the points does not matter. Throws Error(input) for a resolution that no
/// lattice has, or another option out of range. Cost: sorting the points, some 0.2 s, and two
/// trials.
FrameEstimate estimate_frame(std::span<const Vector3f> points, const FrameOptions& options = {});

/// Where the lattice begins against the points.
enum class CuboidPhase {
  zero,    ///< at multiples of the resolution
  centre,  ///< where the points crowd in the middle of cells, on each axis
};

/// Translation (m, below one cell) to add to `frame` so that the points have the phase.
Vector3d phase_shift(std::span<const Vector3f> points, const Pose& frame, double resolution,
                     CuboidPhase phase);

}  // namespace rmap
