#pragma once

#include <cstdint>
#include <limits>

#include <rmap/rtree.hpp>

namespace rmap {

/// How the cells lie in memory. Same map, same answers.
enum class Layout : std::uint8_t {
  blocks,  ///< a leaf branch of the R-tree is a block of 8 x 8 x 8 cells: small and fast
  cells,   ///< a leaf branch is one cell, as in the paper
};

/// What happens to a value at its limits [RMAP 2.2].
enum class Saturation : std::uint8_t {
  clamp,   ///< it stops at the limits and may come back
  freeze,  ///< a cell that reached a limit is never updated again: the paper's literal reading
};

/// Which beams of a scan clear the cells that they cross.
enum class Beams : std::uint8_t {
  all,
  /// Of the beams that share an end cell only the one whose end is nearest to
  /// the cell's centre: an approximation for dense depth images.
  per_end_cell,
};

/// How the cells that a scan's beams cross are found. Same map, bit for bit.
enum class Traversal : std::uint8_t {
  automatic,  ///< whichever is known to be cheaper for the scan
  inverse,    ///< ask each existing cell in view whether a beam crosses it
  forward,    ///< follow each beam: the reference
};

/// What becomes of points beyond the limits of cell indices, or not finite.
enum class BadPoints : std::uint8_t {
  skip,   ///< skipped, and counted by reason in the report
  error,  ///< Error(limit); the grid stays as it was
};

/// Everything a grid is made with, checked together by `check_options`. Names
/// and defaults are OctoMap's where it has them. The second group decides what
/// the map is; the first and the last only how it is kept and computed.
struct Options {
  /// Edge of a cell, metres: 1e-6 to 1e6. Required.
  double resolution = 0;

  Layout layout = Layout::blocks;
  /// M of the R-tree, 4 to 64. Larger: fewer nodes and less memory, more overlap [RMAP 2.1].
  int max_branches = 32;
  Split split = Split::quadratic;

  /// Probability that a cell in which a beam ended is occupied: in (prior, 1).
  double prob_hit = 0.7;
  /// Probability that a cell which a beam crossed is occupied: in (0, prior).
  double prob_miss = 0.4;
  /// Limits of a cell's probability: 0 < clamp_min < prior < clamp_max < 1.
  double clamp_min = 0.1192;
  double clamp_max = 0.971;
  /// Probability of a cell before anything is known of it.
  double prior = 0.5;
  /// A cell is occupied when its probability is above: in [prior, 1).
  double occupied_threshold = 0.5;
  /// What a cell that does not exist counts in [RMAP eq. 1]: in [0, 1].
  double free_probability = 0;
  Saturation saturation = Saturation::clamp;

  /// Points nearer to the sensor are skipped, metres.
  double min_range = 0;
  /// Beams that are longer are cut there, metres: they clear, but end in no cell.
  double max_range = std::numeric_limits<double>::infinity();
  Beams beams = Beams::all;

  BadPoints bad_points = BadPoints::skip;
  Traversal traversal = Traversal::automatic;
  /// Threads that an insertion may use, up to 1024; 0: one for each core. The map does not depend
  /// on it.
  int threads = 1;

  friend bool operator==(const Options&, const Options&) = default;
};

/// Throws Error(input) naming the field, its value and what is allowed, unless
/// the options fit together (also after rounding log-odds to steps of 1/1000).
void check_options(const Options& options);

}  // namespace rmap
