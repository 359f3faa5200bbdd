#pragma once

#include "support/random.hpp"

#include <string>
#include <vector>

#include <rmap/beam.hpp>
#include <rmap/cell.hpp>
#include <rmap/rtree/options.hpp>

namespace rmap::test {

/// Kinds of boxes that an R-tree meets, the nasty ones too.
enum class Data { random, clustered, shell, lattice, repeated, identical, flat, line, huge };

inline constexpr Data kAllData[] = {Data::random,  Data::clustered, Data::shell,
                                    Data::lattice, Data::repeated,  Data::identical,
                                    Data::flat,    Data::line,      Data::huge};

/// `count` boxes of a kind: cubes of `edge`, or any boxes when that is 0.
std::vector<CellBox> boxes_of(Data data, int edge, std::size_t count, Random& random);

/// The beams that traversals get wrong, and plain ones, in and around `bounds`.
inline constexpr int kBeamKinds = 10;
Beam beam_of(int kind, const CellBox& bounds, Random& random);

/// A box in and around `bounds` of up to their size; now and then empty or everything.
CellBox region_of(const CellBox& bounds, Random& random);
/// A cell in and around `bounds`.
Cell cell_of(const CellBox& bounds, Random& random);

/// M in {4, 5, 8, 16, 33, 64} x n in {1, M/2} x split x leaf_edge in {0, 1, 8}.
std::vector<RTreeOptions> all_options();
std::string text_of(const RTreeOptions& options);

}  // namespace rmap::test
