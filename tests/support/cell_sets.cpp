#include "support/cell_sets.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rmap::test {

namespace {

/// Those cells of a box for which `member` holds.
template <class Member>
std::vector<Cell> chosen(const CellBox& box, const Member& member) {
  std::vector<Cell> cells;
  for (std::int32_t z = box.min.z(); z < box.max.z(); ++z) {
    for (std::int32_t y = box.min.y(); y < box.max.y(); ++y) {
      for (std::int32_t x = box.min.x(); x < box.max.x(); ++x) {
        if (member(Cell(x, y, z))) cells.emplace_back(x, y, z);
      }
    }
  }
  return cells;
}

CellBox cube(std::int32_t edge) { return {.min = Cell::Zero(), .max = Cell::Constant(edge)}; }

}  // namespace

std::vector<Cell> solid_box(const CellBox& box) {
  return chosen(box, [](const Cell&) { return true; });
}

std::vector<Cell> hollow_box(const CellBox& box) {
  const CellBox inside{.min = box.min + Cell::Ones(), .max = box.max - Cell::Ones()};
  return chosen(box, [&](const Cell& cell) { return !inside.contains(cell); });
}

std::vector<Cell> ball(std::int32_t radius) {
  const CellBox box{.min = Cell::Constant(-radius), .max = Cell::Constant(radius + 1)};
  return chosen(box, [&](const Cell& cell) { return cell.squaredNorm() <= radius * radius; });
}

std::vector<Cell> stairs(std::int32_t steps) {
  const CellBox box{.min = Cell::Zero(), .max = {3 * steps, 8, 2 * steps}};
  return chosen(box, [](const Cell& cell) { return cell.z() / 2 <= cell.x() / 3; });
}

std::vector<Cell> thin_planes(std::int32_t edge) {
  return chosen(cube(edge), [](const Cell& cell) {
    return cell.x() % 4 == 0 || cell.y() % 4 == 1 || cell.z() % 4 == 2;
  });
}

std::vector<Cell> diagonal_plane(std::int32_t edge) {
  return chosen(cube(edge + 1), [&](const Cell& cell) { return cell.sum() == edge; });
}

std::vector<Cell> random_fill(Random& random, std::int32_t edge, double density) {
  return chosen(cube(edge), [&](const Cell&) { return random.chance(density); });
}

std::vector<Cell> scattered(Random& random, std::size_t count, std::int32_t reach) {
  std::vector<Cell> cells;
  while (cells.size() < count) {
    const Cell cell = random.cell(-reach, reach);
    if (std::find(cells.begin(), cells.end(), cell) == cells.end()) cells.push_back(cell);
  }
  return cells;
}

std::vector<Cell> far_clusters(Random& random) {
  std::vector<Cell> cells = moved(random_fill(random, 10, 0.4), {-3000, 70, -4100});
  for (const Cell& cell : moved(ball(5), {5000, -2500, 3900})) cells.push_back(cell);
  return cells;
}

std::vector<Vector3f> noisy_room_points(Random& random, std::size_t points, double noise) {
  const Vector3d half(3, 2.5, 1.35);
  std::vector<Vector3f> room;
  while (room.size() < points) {
    Vector3d point(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
    point = point.cwiseProduct(half);
    int axis = random.integer(0, 3);
    if (axis == 3) {  // the table
      axis = 2;
      point = {random.real(-0.2, 1.4), random.real(-1.6, -0.8), -0.6};
    } else {
      point[axis] = random.chance(0.5) ? half[axis] : -half[axis];
    }
    point[axis] += random.gaussian(noise);
    room.push_back(point.cast<float>());
  }
  return room;
}

std::vector<Cell> noisy_room(Random& random, std::size_t points, double resolution) {
  const auto room = noisy_room_points(random, points, 0.01);
  std::vector<Cell> cells;
  for (const CountedCell& entry : quantize(room, Lattice(resolution)).cells) {
    cells.push_back(entry.cell);
  }
  return cells;
}

std::vector<Cell> moved(std::vector<Cell> cells, const Cell& by) {
  for (Cell& cell : cells) cell += by;
  return cells;
}

std::vector<CountedCell> counted(const std::vector<Cell>& cells) {
  std::vector<CountedCell> entries;
  for (const Cell& cell : cells) entries.push_back({cell, 1});
  return entries;
}

std::vector<CountedCell> counted(std::vector<Cell> cells, Random& random, std::int32_t most) {
  std::shuffle(cells.begin(), cells.end(), random.engine());
  std::vector<CountedCell> entries;
  for (const Cell& cell : cells) {
    entries.push_back({cell, static_cast<std::uint32_t>(random.integer(1, most))});
  }
  return entries;
}

std::vector<NamedCells> small_scenes(Random& random) {
  const CellBox box{.min = {-9, 3, 60}, .max = {4, 12, 71}};
  std::vector<NamedCells> scenes{{"solid_box", solid_box(box)},
                                 {"hollow_box", hollow_box(box)},
                                 {"ball", ball(7)},
                                 {"stairs", stairs(6)},
                                 {"thin_planes", moved(thin_planes(10), {-4, -5, -6})},
                                 {"diagonal_plane", moved(diagonal_plane(16), {120, -70, 0})},
                                 {"scattered", scattered(random, 100, 15)},
                                 {"far_clusters", far_clusters(random)},
                                 {"noisy_room", noisy_room(random, 3000, 0.25)}};
  for (const double density : {0.1, 0.5, 0.8, 0.95}) {
    scenes.push_back({fmt::format("fill_{}", static_cast<int>(100 * density)),
                      moved(random_fill(random, 11, density), {-5, -5, 60})});
  }
  // Where indices end.
  scenes.push_back(
      {"lowest_indices", moved(random_fill(random, 9, 0.5), Cell::Constant(kMinCellIndex))});
  scenes.push_back(
      {"highest_indices", moved(random_fill(random, 9, 0.5), Cell::Constant(kMaxCellIndex - 8))});
  return scenes;
}

}  // namespace rmap::test
