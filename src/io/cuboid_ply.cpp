#include "io/bytes.hpp"
#include "io/color_map.hpp"
#include "io/cuboid_formats.hpp"
#include "io/input_boxes.hpp"

#include <limits>

#include <fmt/format.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr unsigned kCorners = 8;

// Indices are signed: many readers know no others.
void check_count(const AtomicFile& file, std::size_t cuboids) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max() / kCorners;
  if (cuboids <= kMost) return;
  throw Error(ErrorKind::limit, fmt::format("{} cannot hold {} cuboids: at most {} are allowed",
                                            file.target().string(), cuboids, kMost));
}

}  // namespace

void write_cuboid_ply(AtomicFile& file, const CuboidList& list) {
  check_count(file, list.cuboids.size());
  const InputBoxes boxes(list);
  HeightScale scale;
  for (const Cuboid& cuboid : list.cuboids) {
    for (unsigned i = 0; i < kCorners; ++i) scale.add(boxes.corner(cuboid.cells, i).z());
  }
  // Doubles, since maps may lie far from the origin.
  file.write(fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment cuboids in the frame of the input, metres\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      kCorners * list.cuboids.size(), kBoxTriangles.size() * list.cuboids.size()));
  for (const Cuboid& cuboid : list.cuboids) {
    for (unsigned i = 0; i < kCorners; ++i) {
      const Vector3d corner = boxes.corner(cuboid.cells, i);
      for (const double coordinate : corner) file.write(little_endian(coordinate));
      for (const auto part : viridis(scale.share(corner.z()))) file.write(little_endian(part));
    }
  }
  for (std::size_t box = 0; box < list.cuboids.size(); ++box) {
    for (const auto& triangle : kBoxTriangles) {
      file.write(little_endian(std::uint8_t{3}));
      for (const unsigned corner : triangle) {
        file.write(little_endian(static_cast<std::int32_t>(kCorners * box + corner)));
      }
    }
  }
}

}  // namespace rmap
