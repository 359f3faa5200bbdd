#include <rmap/cell.hpp>

namespace rmap {

double CellBox::volume() const {
  if (empty()) return 0;
  __extension__ using Uint128 = unsigned __int128;
  const auto edges = extent();
  const Uint128 cells = static_cast<Uint128>(edges.x()) * static_cast<Uint128>(edges.y()) *
                        static_cast<Uint128>(edges.z());
  return static_cast<double>(cells);
}

}  // namespace rmap
