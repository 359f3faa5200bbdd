#include "rtree/boxes.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace rmap::test {

namespace {

CellBox cube(const Cell& min, int edge) { return {.min = min, .max = min + Cell::Constant(edge)}; }

Cell clamped(const Cell& cell) {
  return cell.cwiseMax(Cell::Constant(kMinCellIndex)).cwiseMin(Cell::Constant(kMaxCellIndex));
}

/// The first `count` places of a lattice that `wanted` accepts, in random order.
template <class Wanted>
std::vector<CellBox> lattice_boxes(int edge, std::size_t count, Random& random,
                                   const Wanted& wanted) {
  const int step = edge > 0 ? edge : 4;
  int side = 1;
  const auto places = [&] {
    std::vector<Cell> found;
    for (int x = 0; x < side; ++x) {
      for (int y = 0; y < side; ++y) {
        for (int z = 0; z < side; ++z) {
          if (wanted(Cell(x, y, z), side)) found.emplace_back(x, y, z);
        }
      }
    }
    return found;
  };
  std::vector<Cell> found = places();
  for (; found.size() < count; ++side) found = places();
  std::shuffle(found.begin(), found.end(), random.engine());
  std::vector<CellBox> boxes;
  for (std::size_t i = 0; i < count; ++i) {
    boxes.push_back(cube((found[i] - Cell::Constant(side / 2)) * step, step));
  }
  return boxes;
}

CellBox random_box(int edge, int reach, Random& random) {
  return edge > 0 ? cube(random.cell(-reach, reach), edge) : random.box(-reach, reach, 12);
}

CellBox huge_box(int edge, Random& random) {
  if (edge > 0) {
    Cell min = Cell::Zero();
    for (int axis = 0; axis < 3; ++axis) {
      const int side = random.integer(-1, 1);
      if (side < 0) min[axis] = kMinCellIndex + random.integer(0, 2);
      if (side > 0) min[axis] = kMaxCellIndex + 1 - edge - random.integer(0, 2);
    }
    return cube(min, edge);
  }
  CellBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const bool whole = random.chance(0.5);
    box.min[axis] = whole ? kMinCellIndex : random.integer(kMinCellIndex, kMaxCellIndex);
    box.max[axis] = whole ? kMaxCellIndex + 1 : random.integer(box.min[axis], kMaxCellIndex) + 1;
  }
  return box;
}

}  // namespace

std::vector<CellBox> boxes_of(Data data, int edge, std::size_t count, Random& random) {
  const int cube_edge = edge > 0 ? edge : 3;
  std::vector<CellBox> boxes;
  switch (data) {
    case Data::shell:
      return lattice_boxes(edge, count, random, [](const Cell& place, int side) {
        return place.minCoeff() == 0 || place.maxCoeff() == side - 1;
      });
    case Data::lattice:
      return lattice_boxes(edge, count, random, [](const Cell&, int) { return true; });
    case Data::random:
      while (boxes.size() < count) boxes.push_back(random_box(edge, 60, random));
      return boxes;
    case Data::clustered:
      while (boxes.size() < count) {
        const Cell center = random.cell(-1000, 1000);
        for (int i = 0; i < 30 && boxes.size() < count; ++i) {
          CellBox box = random_box(edge, 10, random);
          box.min += center;
          box.max += center;
          boxes.push_back(box);
        }
      }
      std::shuffle(boxes.begin(), boxes.end(), random.engine());
      return boxes;
    case Data::repeated:
      for (int i = 0; i < 7; ++i) boxes.push_back(random_box(edge, 8, random));
      while (boxes.size() < count) {
        boxes.push_back(boxes[static_cast<std::size_t>(random.integer(0, 6))]);
      }
      boxes.resize(count);
      return boxes;
    case Data::identical:
      return {count, cube({-5, 3, 8}, cube_edge)};
    case Data::flat:
      while (boxes.size() < count) {
        CellBox box = random_box(edge, 60, random);
        box.max.z() += -box.min.z();
        box.min.z() = 0;
        if (edge == 0) box.max.z() = 1;
        boxes.push_back(box);
      }
      return boxes;
    case Data::line:
      for (std::size_t i = 0; i < count; ++i) {
        boxes.push_back(cube({static_cast<int>(i) * cube_edge, 0, 0}, cube_edge));
      }
      return boxes;
    case Data::huge:
      while (boxes.size() < count) boxes.push_back(huge_box(edge, random));
      return boxes;
  }
  return boxes;
}

Cell cell_of(const CellBox& bounds, Random& random) {
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    cell[axis] = random.integer(std::max(bounds.min[axis] - 4, kMinCellIndex),
                                std::min(bounds.max[axis] + 3, kMaxCellIndex));
  }
  return cell;
}

CellBox region_of(const CellBox& bounds, Random& random) {
  const Cell a = cell_of(bounds, random);
  const Cell b = cell_of(bounds, random);
  switch (random.integer(0, 9)) {
    case 0:
      return all_cells();
    case 1:
      return bounds;
    case 2:
      return {.min = a, .max = a};  // empty, though between the faces of boxes around it
    case 3:
      return {.min = a.cwiseMax(b), .max = a.cwiseMin(b)};
    case 4:
      return box_of(a);
    case 5:
      return {.min = a, .max = (a.array().min(kMaxCellIndex - 10) + 10).matrix().cwiseMax(a)};
    default:
      return {.min = a.cwiseMin(b), .max = a.cwiseMax(b) + Cell::Ones()};
  }
}

Beam beam_of(int kind, const CellBox& bounds, Random& random) {
  const auto on_lattice = [&] { return Vector3d(cell_of(bounds, random).cast<double>()); };
  const auto anywhere = [&] { return Vector3d(on_lattice() + random.point(0, 1)); };
  const int axis = random.integer(0, 2);
  Vector3d origin = on_lattice();
  Vector3d end = on_lattice();
  switch (kind) {
    case 0:
      return {anywhere(), anywhere(), false};
    case 1:
      return {anywhere(), anywhere(), true};
    case 2:  // along an axis, within a cell
      origin = anywhere();
      std::swap(end, origin);
      end = origin;
      end[axis] = anywhere()[axis];
      return {origin, end, random.chance(0.5)};
    case 3:  // along an axis, in an edge of the lattice
      origin = end;
      origin[axis] = on_lattice()[axis];
      return {origin, end, random.chance(0.5)};
    case 4:  // in a face
      origin[axis] = end[axis];
      return {origin, end, false};
    case 5:  // from corner to corner
      return {origin, end, random.chance(0.5)};
    case 6: {  // through corners along a diagonal
      const int length = random.integer(-9, 9);
      const Cell to = clamped(origin.cast<std::int32_t>() + Cell(length, -length, length));
      return {origin, to.cast<double>(), false};
    }
    case 7:  // all but parallel: one component vanishes, or all but does
      end[axis] = origin[axis] + (random.chance(0.5) ? 0x1p-41 : 0x1p-39);
      return {origin, end, false};
    case 8:  // no length
      return {origin, origin, random.chance(0.5)};
    default:  // on half cells
      origin += Vector3d::Constant(0.5);
      return {origin, end + Vector3d::Constant(0.5), false};
  }
}

std::vector<RTreeOptions> all_options() {
  std::vector<RTreeOptions> all;
  for (const int max_branches : {4, 5, 8, 16, 33, 64}) {
    for (const int min_branches : {1, max_branches / 2}) {
      for (const Split split : {Split::quadratic, Split::linear}) {
        for (const int leaf_edge : {0, 1, 8}) {
          all.push_back({.max_branches = max_branches,
                         .min_branches = min_branches,
                         .split = split,
                         .leaf_edge = leaf_edge});
        }
      }
    }
  }
  return all;
}

std::string text_of(const RTreeOptions& options) {
  return fmt::format("M {}, n {}, {} split, leaf_edge {}", options.max_branches,
                     options.min_branches,
                     options.split == Split::quadratic ? "quadratic" : "linear", options.leaf_edge);
}

}  // namespace rmap::test
