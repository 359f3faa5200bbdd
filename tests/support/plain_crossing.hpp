#pragma once

#include <array>
#include <vector>

#include <rmap/box.hpp>
#include <rmap/cell.hpp>

namespace rmap::test {

/// A beam as the definition has it, written down a second time and without any
/// cleverness: the oracle for everything that says what a beam crosses.
struct PlainBeam {
  std::array<double, 3> origin;
  std::array<double, 3> end;
  bool cut;
};

/// Whether the beam (in cell units) crosses the cell.
bool plain_crosses(const PlainBeam& beam, const Cell& cell);

/// Every cell of a box that the beam crosses, found by asking each one.
std::vector<Cell> plain_crossed_cells(const PlainBeam& beam, const CellBox& box);

}  // namespace rmap::test
