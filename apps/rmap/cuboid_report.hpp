#pragma once

#include "json.hpp"

#include <string>
#include <vector>

#include <rmap/cuboid_error.hpp>
#include <rmap/cuboids.hpp>

namespace rmap::command {

/// How cuboids stand for their cells: errors, bytes in several forms, and the R-tree's for M = 8,
/// 16 and 32 [RMAP Table 1].
struct CuboidEvaluation {
  CuboidError error;
  CuboidBytes bytes;
  std::vector<std::pair<int, std::size_t>> rtree_bytes;  ///< by M
};

CuboidEvaluation evaluate_cuboids(std::span<const CountedCell> cells,
                                  std::span<const Cuboid> cuboids);

/// The fields of the errors, without bytes.
Json json_of(const CuboidError& error);
Json json_of(const CuboidBytes& bytes);
/// {"translation": [x, y, z], "rotation": [qx, qy, qz, qw]}
Json json_of_frame(const Pose& frame);

/// Lines for people.
std::string error_lines(const CuboidError& error);
std::string byte_lines(const CuboidEvaluation& evaluation);
/// What the figures mean for the use of the cuboids, where that is easily overlooked.
std::vector<std::string> remarks(const CuboidEvaluation& evaluation);

/// "identity", or the angle of the rotation in words.
std::string readable_frame(const Pose& frame);

}  // namespace rmap::command
