#pragma once

#include <rmap/pose.hpp>

namespace rmap {

/// The pose of the 12 numbers of a 3x4 matrix, row by row. Throws as check_pose.
Pose matrix_pose(const double* numbers);

// Poses out of poses, in an arithmetic that every machine computes alike: double, without fused
// multiply-add, in the order that is named here, and by square roots instead of sines.

/// a_from_c of a_from_b and b_from_c: each number of the rotation is
/// (r0*s0 + r1*s1) + r2*s2, each of the translation ((r0*x + r1*y) + r2*z) + t.
Pose composed(const Pose& a_from_b, const Pose& b_from_c);

/// b_from_a of a_from_b, a rotation and a translation: transposed, and minus its product with
/// the translation.
Pose inverted(const Pose& a_from_b);

/// The pose at `share` (0 to 1) of the way between two: straight for the translation, along the
/// shorter arc at even speed for the rotation (slerp).
Pose between(const Pose& before, const Pose& after, double share);

}  // namespace rmap
