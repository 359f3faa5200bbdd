#pragma once

#include "support/random.hpp"

#include <string>
#include <vector>

#include <rmap/box.hpp>
#include <rmap/counted_cells.hpp>

namespace rmap::test {

/// Sets of occupied cells, each cell once, that approximations are tried on.
std::vector<Cell> solid_box(const CellBox& box);
/// The walls, one cell thick, of a box.
std::vector<Cell> hollow_box(const CellBox& box);
std::vector<Cell> ball(std::int32_t radius);
std::vector<Cell> stairs(std::int32_t steps);
/// Planes one cell thick across each axis, three cells apart.
std::vector<Cell> thin_planes(std::int32_t edge);
/// The plane x + y + z = edge: no two of its cells share a face.
std::vector<Cell> diagonal_plane(std::int32_t edge);
/// Each cell of a cube is there with this probability.
std::vector<Cell> random_fill(Random& random, std::int32_t edge, double density);
std::vector<Cell> scattered(Random& random, std::size_t count, std::int32_t reach);
/// Two clusters with thousands of cells between them.
std::vector<Cell> far_clusters(Random& random);
/// The cells, `resolution` wide, of noisy_room_points.
std::vector<Cell> noisy_room(Random& random, std::size_t points, double resolution);

/// Points on the walls, the floor, the ceiling and a table of a room of 6 x 5 x 2.7 m around the
/// origin, with Gaussian noise (m) across.
std::vector<Vector3f> noisy_room_points(Random& random, std::size_t points, double noise);

std::vector<Cell> moved(std::vector<Cell> cells, const Cell& by);
/// The cells with one point each.
std::vector<CountedCell> counted(const std::vector<Cell>& cells);
/// The same with 1 to `most` points, in random order.
std::vector<CountedCell> counted(std::vector<Cell> cells, Random& random, std::int32_t most);

struct NamedCells {
  std::string name;
  std::vector<Cell> cells;
};
/// One of each kind, small enough to look at every cell: some hundred to a few thousand.
std::vector<NamedCells> small_scenes(Random& random);

}  // namespace rmap::test
