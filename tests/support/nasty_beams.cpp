#include "support/nasty_beams.hpp"

#include <cmath>

namespace rmap::test {

namespace {

// The lattice point next to `value`.
double on_lattice(double value) { return std::round(value); }

}  // namespace

std::string name_of(BeamKind kind) {
  constexpr const char* kNames[kBeamKinds] = {
      "random",          "axis_parallel",   "in_face",      "along_edge",
      "through_corners", "on_lattice",      "half_lattice", "zero_length",
      "tiny_component",  "origin_on_plane", "end_on_plane", "short_beam"};
  return kNames[static_cast<int>(kind)];
}

BeamEnds nasty_beam(BeamKind kind, Random& random, double reach, const Vector3d& center) {
  Vector3d origin = center + random.point(-reach, reach);
  Vector3d end = center + random.point(-reach, reach);
  const int axis = random.integer(0, 2);
  const int other = (axis + random.integer(1, 2)) % 3;
  switch (kind) {
    case BeamKind::random:
      break;
    case BeamKind::axis_parallel: {
      const double along = end[axis];
      end = origin;
      end[axis] = random.chance(0.3) ? on_lattice(along) : along;
      break;
    }
    case BeamKind::in_face:
      origin[axis] = end[axis] = on_lattice(origin[axis]);
      break;
    case BeamKind::along_edge:
      origin[axis] = end[axis] = on_lattice(origin[axis]);
      origin[other] = end[other] = on_lattice(origin[other]);
      break;
    case BeamKind::through_corners: {
      origin = origin.unaryExpr(&on_lattice);
      const double length = random.integer(1, static_cast<int>(reach));
      for (int i = 0; i < 3; ++i) end[i] = origin[i] + (random.chance(0.5) ? length : -length);
      break;
    }
    case BeamKind::on_lattice:
      origin = origin.unaryExpr(&on_lattice);
      end = end.unaryExpr(&on_lattice);
      break;
    case BeamKind::half_lattice:
      origin = origin.unaryExpr(&on_lattice).array() + 0.5;
      end = end.unaryExpr(&on_lattice).array() + 0.5;
      break;
    case BeamKind::zero_length:
      if (random.chance(0.5)) origin = origin.unaryExpr(&on_lattice);
      end = origin;
      break;
    case BeamKind::tiny_component: {
      constexpr double kSizes[] = {0x1p-60, 0x0.ffp-40, 0x1p-40, 0x1.01p-40, 0x1p-30};
      const double size = kSizes[random.integer(0, 4)];
      if (random.chance(0.5)) origin[axis] = on_lattice(origin[axis]);
      end[axis] = origin[axis] + (random.chance(0.5) ? size : -size);
      break;
    }
    case BeamKind::origin_on_plane:
      origin[axis] = on_lattice(origin[axis]);
      break;
    case BeamKind::end_on_plane:
      end[axis] = on_lattice(end[axis]);
      break;
    case BeamKind::short_beam:
      end = origin + random.point(-1, 1);
      break;
  }
  return {origin, end};
}

}  // namespace rmap::test
