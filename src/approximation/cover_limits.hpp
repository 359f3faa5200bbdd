#pragma once

namespace rmap {

struct CoverLimits {
  int outer = 0;        ///< how far an empty cell in a box may be from a cell, Chebyshev
  int inner = 0;        ///< how far a cell may be from a box
  bool reshape = true;  ///< false: faster, and some percent more boxes
};

}  // namespace rmap
