#include "grid/tile_loader.hpp"

#include <algorithm>
#include <cassert>

namespace rmap {

namespace {

constexpr std::size_t kMaxLanes = 16;

PointKernelInput kernel_input(const ScanBeams& beams, const Vector3d& origin, TileDetail detail) {
  const Scan& scan = beams.scan();
  PointKernelInput input{
      .map_from_points = {},
      .moves = scan.frame == Frame::sensor,
      .origin = origin,
      .origin_in_cells = beams.lattice().to_cells(origin),
      .inverse = beams.lattice().inverse(),
      .min_range = beams.options().min_range,
      .max_range = beams.options().max_range,
      .detail = detail,
  };
  for (std::size_t i = 0; i < 12; ++i) {
    input.map_from_points[i] =
        scan.map_from_sensor(static_cast<Eigen::Index>(i / 4), static_cast<Eigen::Index>(i % 4));
  }
  return input;
}

}  // namespace

TileLoader::TileLoader(const ScanBeams& beams, const Vector3d& origin, TileDetail detail)
    : beams_(beams), input_(kernel_input(beams, origin, detail)) {}

void TileLoader::load(std::size_t first, std::size_t count, PointTile& tile) {
  assert(count <= PointTile::kSize);
  tile.count = count;
  tile.first = first;
  tile.numbers = {};
  fill(tile);
}

void TileLoader::load(std::span<const std::uint32_t> numbers, PointTile& tile) {
  assert(numbers.size() <= PointTile::kSize);
  tile.count = numbers.size();
  tile.numbers = numbers;
  fill(tile);
}

void TileLoader::fill(PointTile& tile) {
  tile.ends.clear();
  tile.beams.clear();
  tile.cuts.clear();
  tile.cut_at_origin = false;

  // The kernel reads whole vectors: what is not in a row, or at the end of the points, is copied.
  const std::vector<Vector3f>& points = beams_.scan().points;
  std::array<float, 3 * PointTile::kSize> copy;
  const float* source = nullptr;
  std::size_t plain = tile.count;  // places that hold a point
  while (plain > 0 && tile.number(plain - 1) >= points.size()) --plain;
  if (tile.numbers.empty() && tile.first + plain + kMaxLanes <= points.size()) {
    source = points[tile.first].data();
  } else {
    for (std::size_t i = 0; i < plain; ++i) {
      std::copy_n(points[tile.number(i)].data(), 3, copy.data() + 3 * i);
    }
    std::fill(copy.begin() + static_cast<std::ptrdiff_t>(3 * plain), copy.end(), 0.0f);
    source = copy.data();
  }
  compute_points(input_, source, plain, tile);

  tile.ends.missing(tile.count).for_each([&](std::size_t i) {
    const SortedPoint point = beams_.sorted(tile.number(i));
    if (point.fate == SortedPoint::Fate::skipped) {
      ++(skipped_.*point.reason);
      return;
    }
    const bool is_cut = point.fate == SortedPoint::Fate::cut;
    const Beam beam(point.origin, point.end, is_cut);
    (is_cut ? tile.cuts : tile.ends).set(i);
    if (beam.direction() != Vector3d::Zero()) {
      if (input_.detail != TileDetail::cells) tile.beams.set(i);
    } else if (is_cut) {
      tile.cut_at_origin = true;
    }
    const Cell cell = *cell_at(point.end);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      tile.end[axis][i] = point.end[at];
      tile.cell[axis][i] = cell[at];
      tile.direction[axis][i] = static_cast<float>(beam.direction()[at]);
    }
  });
  cut_ += tile.cuts.count();
}

}  // namespace rmap
