#pragma once

#include "support/random.hpp"

#include <vector>

#include <rmap/grid.hpp>
#include <rmap/map_file.hpp>

namespace rmap::test {

/// Options of which every one that is part of the map differs from its default.
Options all_options_changed();
/// Several sets of options: the defaults, all changed, those at the ends of what is allowed.
std::vector<Options> various_options();

/// Every layout, with the smallest, the usual and the largest R-tree.
std::vector<LoadOptions> various_load_options();

/// A map made by hand, a few hundred bytes as a file: negative and positive cells,
/// two poses, all options changed.
Grid small_map();
/// `options` with what is `in_memory`.
Options with(Options options, const LoadOptions& in_memory);

/// Some poses that are sound, with zeros of both signs in them.
std::vector<Pose> random_poses(Random& random, int count);

/// A map of single cells, clusters and a full block, near the origin, far away and at
/// the limits, with all values there are; poses and history too.
Grid random_map(Random& random, const Options& options);

/// The same map, made in another order of cells.
Grid rebuilt(const Grid& grid, Random& random, const Options& options);

}  // namespace rmap::test
