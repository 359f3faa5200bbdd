#include "grid/cell_places.hpp"

#include <algorithm>
#include <cstddef>

#include <rmap/error.hpp>
#include <rmap/packed_cuboids.hpp>

namespace rmap {

namespace {

constexpr std::int32_t kChunkEdge = 256;

Cell chunk_origin(const Cell& cell) {
  return cell.unaryExpr([](std::int32_t index) { return index & ~(kChunkEdge - 1); });
}

PackedCuboid packed(const CellBox& box, const Cell& origin) {
  PackedCuboid cuboid;
  for (int axis = 0; axis < 3; ++axis) {
    cuboid.offset[axis] = static_cast<std::uint8_t>(box.min[axis] - origin[axis]);
    cuboid.edge_less_one[axis] = static_cast<std::uint8_t>(box.max[axis] - box.min[axis] - 1);
  }
  return cuboid;
}

CellBox unpacked(const PackedCuboid& cuboid, const Cell& origin) {
  CellBox box;
  for (int axis = 0; axis < 3; ++axis) {
    box.min[axis] = origin[axis] + cuboid.offset[axis];
    box.max[axis] = box.min[axis] + cuboid.edge_less_one[axis] + 1;
  }
  return box;
}

/// use(part) for the parts of a box with edges of 256 cells at most.
template <class Use>
void for_each_part(const CellBox& box, const Use& use) {
  Cell at;
  for (at.z() = box.min.z(); at.z() < box.max.z(); at.z() += kChunkEdge) {
    for (at.y() = box.min.y(); at.y() < box.max.y(); at.y() += kChunkEdge) {
      for (at.x() = box.min.x(); at.x() < box.max.x(); at.x() += kChunkEdge) {
        use({.min = at, .max = (at.array() + kChunkEdge).min(box.max.array()).matrix()});
      }
    }
  }
}

void check_parts(std::span<const Cuboid> cuboids) {
  constexpr double kMostParts = 1 << 28;
  double parts = 0;
  for (const Cuboid& cuboid : cuboids) {
    if (!all_cells().contains(cuboid.cells)) {
      throw Error(ErrorKind::limit, "a cuboid is empty or beyond the limits of cell indices");
    }
    const Eigen::Array3d edges = cuboid.cells.extent().cast<double>().array();
    parts += (edges / kChunkEdge).ceil().prod();
  }
  if (parts > kMostParts) {
    throw Error(ErrorKind::limit, "the cuboids are too long to be packed: more than 2^28 parts");
  }
}

}  // namespace

std::vector<CuboidChunk> pack(std::span<const Cuboid> cuboids) {
  check_parts(cuboids);
  std::vector<CuboidChunk> chunks;
  CellPlaces places;
  for (const Cuboid& cuboid : cuboids) {
    for_each_part(cuboid.cells, [&](const CellBox& part) {
      const Cell origin = chunk_origin(part.min);
      const std::uint32_t place =
          places.add(origin, CellPlaces::hash_of(origin),
                     [&](std::uint32_t i) -> const Cell& { return chunks[i].origin; });
      if (place == chunks.size()) chunks.push_back({origin, {}});
      chunks[place].cuboids.push_back(packed(part, origin));
    });
  }
  return chunks;
}

std::vector<Cuboid> unpack(std::span<const CuboidChunk> chunks) {
  std::vector<Cuboid> cuboids;
  for (const CuboidChunk& chunk : chunks) {
    for (const PackedCuboid& cuboid : chunk.cuboids) {
      cuboids.push_back({unpacked(cuboid, chunk.origin), 0});
    }
  }
  return cuboids;
}

}  // namespace rmap
