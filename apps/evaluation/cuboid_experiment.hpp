#pragma once

#include "evaluation/json.hpp"

#include <array>
#include <string>
#include <vector>

#include <rmap/approximate.hpp>

namespace rmap::evaluation {

/// A cloud to be approximated.
struct CloudScene {
  std::string name = {};
  std::string source = {};  ///< for people
  double resolution = 0;
  std::vector<Vector3f> points;
};

/// What a cloud takes without cuboids, bytes [RMAP 3.3, Table 1].
struct CloudBytes {
  std::string scene = {};
  double resolution = 0;
  std::uint64_t points = 0;
  std::uint64_t cells = 0;
  std::uint64_t raw_points = 0;      ///< 12 a point
  std::uint64_t fixed_cells = 0;     ///< 12 a cell
  std::uint64_t octomap = 0;         ///< of the ends alone: 80 an inner node, 16 a leaf
  std::uint64_t octomap_pruned = 0;  ///< the same, eight equal leaves joined to one
};

/// One approximation of it.
struct CuboidRow {
  std::string scene = {};
  double resolution = 0;
  std::string method = {};  ///< kMidpoint, kExact, kDefault
  std::string varied = {};  ///< "sigma" or "omega": of which curve it is a point
  double sigma = 1;
  std::uint64_t omega = 1;
  double ns_per_point = 0;  ///< quantising and approximating, of all points
  std::size_t cuboids = 0;
  double unapproximated_percent = 0;              ///< of the points
  double false_percent = 0;                       ///< empty cells, of the volume of the cuboids
  std::uint64_t bytes = 0;                        ///< 24 a cuboid, as the paper has it
  std::uint64_t packed_bytes = 0;                 ///< 8 a cuboid
  std::array<std::uint64_t, 3> rtree_bytes = {};  ///< in R-trees of M = 8, 16, 32
};

struct CuboidFindings {
  std::vector<CloudBytes> clouds = {};
  std::vector<CuboidRow> rows = {};
};

/// The paper's recursion, a box taken from half full on; ours without false cells; ours with at
/// most a quarter of them.
inline constexpr char kMidpoint[] = "midpoint";
inline constexpr char kExact[] = "exact";
inline constexpr char kDefault[] = "default";

Json to_json(const CloudBytes& bytes);
Json to_json(const CuboidRow& row);

/// sigma from 0.5 to 1 with omega off, omega from 1 to 64 cells with sigma 1.
void cuboid_experiment(const CloudScene& scene, int repetitions, CuboidFindings& findings);

/// A noisy room, a sphere looked at from all around (a dense scanned object): simulated.
std::vector<CloudScene> simulated_clouds(std::uint64_t seed);

}  // namespace rmap::evaluation
