#pragma once

#include "support/random.hpp"

#include <string>
#include <vector>

#include <rmap/box.hpp>

namespace rmap::test {

/// Kinds of beams on which traversals break.
enum class BeamKind {
  random,
  axis_parallel,    ///< two components of the direction are exactly 0
  in_face,          ///< lies in a plane of the lattice
  along_edge,       ///< lies in two planes of the lattice
  through_corners,  ///< diagonal from lattice point to lattice point
  on_lattice,       ///< both ends on the lattice
  half_lattice,     ///< both ends on half-integers
  zero_length,
  tiny_component,  ///< a component just below, at or above 2^-40
  origin_on_plane,
  end_on_plane,
  short_beam,  ///< within one cell or two
};
inline constexpr int kBeamKinds = 12;
std::string name_of(BeamKind kind);

/// Ends of a beam in cell units.
struct BeamEnds {
  Vector3d origin;
  Vector3d end;
};

/// A beam of a kind; coordinates lie within +-`reach` cells of `center`.
BeamEnds nasty_beam(BeamKind kind, Random& random, double reach,
                    const Vector3d& center = Vector3d::Zero());

}  // namespace rmap::test
