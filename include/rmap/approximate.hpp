#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <rmap/counted_cells.hpp>
#include <rmap/cuboids.hpp>

namespace rmap {

/// How cells become cuboids.
enum class CuboidMethod {
  automatic,  ///< cover; split where there is no `outer`
  cover,      ///< boxes as large as `outer` allows, and few of them; they may overlap
  split,      ///< cut top down, and merged again under `outer` and `max_false`
  runs,       ///< rows joined to rectangles joined to boxes: disjoint, exact, fastest
  midpoint,   ///< the paper's recursion: shrink, accept by `fill`, else halve [RMAP 2.3]
};

/// What is wanted of an approximation. Errors are in cells, as Chebyshev distances.
struct ApproximationOptions {
  CuboidMethod method = CuboidMethod::automatic;
  /// A, 0 to 3: a cuboid may hold empty cells, none farther than this from an occupied one.
  /// Nothing: as far as `max_false` allows, which only split does. Midpoint goes by `fill` alone,
  /// and runs are exact.
  std::optional<int> outer = 1;
  /// B, 0 to 3: an occupied cell may stay outside, none farther than this from a cuboid. Holds
  /// with sigma 1 and omega off.
  int inner = 0;
  /// Share of the weight to cover, in (0, 1]: the list ends as soon as it does.
  double sigma = 1;
  CuboidWeight weight = CuboidWeight::cells;
  /// Smallest weight that a cuboid must add to the list [RMAP 2.3]; 1: off.
  std::uint64_t omega = 1;
  /// Largest share of empty cells in the volume of the union of all cuboids, in [0, 1), for cover
  /// and split; they then lose no cell, whatever `inner` is. What sigma, omega and max_cuboids
  /// leave of the list may have a larger one.
  std::optional<double> max_false = 0.25;
  /// The list ends here.
  std::size_t max_cuboids = std::numeric_limits<std::size_t>::max();
  /// midpoint: share of occupied cells from which on a box is accepted, in (0, 1].
  double fill = 1;
  /// midpoint: volume in cells up to which a box is accepted as it is.
  std::uint64_t smallest_volume = 1;
  /// 0: one for each core. The result does not depend on it.
  int threads = 1;
};

/// Named choices: `exact` (nothing false, nothing lost), `default` (at most 25 % false, none
/// farther than a cell), `compact` (empty cells up to one cell off), `sketch` (empty cells up to
/// two cells off, 98 % of the weight in a cuboid or next to one, no cuboid that adds less than 4).
/// Throws Error(input) for another name.
ApproximationOptions approximation_preset(std::string_view name);

/// How a list of cuboids came about.
struct ApproximationReport {
  CuboidMethod method = CuboidMethod::cover;  ///< never automatic
  std::string why;                            ///< why this method, in words
  std::uint64_t cells = 0;                    ///< occupied cells of the input
  std::uint64_t points = 0;
  std::uint64_t weight = 0;    ///< of all cells, as the options count it
  std::uint64_t covered = 0;   ///< of the cells in the list's cuboids (or near: B)
  std::size_t cut = 0;         ///< cuboids that sigma, omega, max_cuboids left out
  double seconds_boxes = 0;    ///< time to find boxes
  double seconds_ranking = 0;  ///< time to order them
};

struct Approximation {
  std::vector<Cuboid> cuboids;  ///< the one that covers most first
  ApproximationReport report;
};

/// Few cuboids for a set of occupied cells, which may come in any order and repeat. Lists for
/// different sigma are prefixes of one another. The same for the same cells, however they are
/// ordered, and for any number of threads. Throws Error(input) when an option is out of range, or
/// as check_cells. Cost: microseconds a cell, docs/benchmarks.md; memory: by cells.
Approximation approximate(std::span<const CountedCell> cells,
                          const ApproximationOptions& options = {});

}  // namespace rmap
