#pragma once

#include <vector>

#include <rmap/beam.hpp>
#include <rmap/lattice.hpp>
#include <rmap/options.hpp>
#include <rmap/report.hpp>
#include <rmap/scan.hpp>

namespace rmap {

/// A scan in cell units, its points sorted out by the filters of the options.
struct SortedScan {
  /// The beams that clear; empty for Content::end_cells.
  std::vector<Beam> beams;
  /// The cell of each point that ends in one; several points may share a cell.
  std::vector<Cell> end_cells;

  std::uint64_t points = 0;
  std::uint64_t cut = 0;
  SkippedPoints skipped;
};

/// What a sorted scan is needed for.
enum class Content { end_cells, end_cells_and_beams };

/// Sorts out the points of a scan, in this order: not finite; nearer than
/// min_range; beyond max_range (cut there); beyond the limits of cell indices.
/// Throws as Grid::insert.
SortedScan sorted(const Scan& scan, const Lattice& lattice, const Options& options,
                  Content content);

/// Of the beams that share an end cell keeps the one whose end is nearest to the
/// cell's centre (ties: smallest end, then smallest origin, by x, y, z); cut beams stay.
void keep_one_beam_per_end_cell(std::vector<Beam>& beams);

}  // namespace rmap
