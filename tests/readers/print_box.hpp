#pragma once

#include <cstdio>

/// What each reader prints for a box: centre, quaternion (x, y, z, w), edge lengths.
inline void print_box(const double (&center)[3], const double (&turn)[4], const double (&size)[3]) {
  std::printf("box %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g %.17g\n", center[0],
              center[1], center[2], turn[0], turn[1], turn[2], turn[3], size[0], size[1], size[2]);
}
