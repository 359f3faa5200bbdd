#include "io/rmap_blocks.hpp"
#include "io/rmap_records.hpp"
#include "io/rmap_writer.hpp"
#include "io/sorted_leaves.hpp"

#include <algorithm>

#include <rmap/map_file.hpp>

namespace rmap {

namespace {

// use(leaves of one block) for each block.
template <class Use>
void for_each_block(std::span<const Leaf> leaves, Use&& use) {
  while (!leaves.empty()) {
    const Cell origin = block_origin(leaves.front().origin);
    const auto next = std::find_if(leaves.begin(), leaves.end(), [&](const Leaf& leaf) {
      return block_origin(leaf.origin) != origin;
    });
    const auto count = static_cast<std::size_t>(next - leaves.begin());
    use(origin, leaves.first(count));
    leaves = leaves.subspan(count);
  }
}

void write_poses(RmapWriter& writer, std::span<const Pose> poses) {
  while (!poses.empty()) {
    const auto piece = poses.first(std::min(poses.size(), wire::kMaxPosesPerChunk));
    writer.add(wire::kPoses, wire::encoded_poses(piece), wire::least_size_of_poses(piece.size()));
    poses = poses.subspan(piece.size());
  }
}

void write_blocks(RmapWriter& writer, std::span<const Leaf> leaves) {
  wire::BlockEncoder encoder;
  const auto flush = [&] {
    if (encoder.blocks() == 0) return;
    const auto least = wire::least_size_of_blocks(encoder.blocks(), encoder.cells());
    writer.add(wire::kCells, encoder.take_content(), least);
  };
  for_each_block(leaves, [&](const Cell& origin, std::span<const Leaf> its_leaves) {
    if (encoder.blocks() == wire::kMaxBlocksPerChunk) flush();
    encoder.add_block(origin);
    for (const Leaf& leaf : its_leaves) {
      const CellMask cells =
          leaf.edge == 1 ? CellMask::single(block_position(leaf.origin)) : leaf.cells();
      encoder.add_cells(cells, {leaf.values(), cells.count()});
    }
  });
  flush();
}

}  // namespace

void save(const Grid& grid, const std::filesystem::path& file) {
  const std::vector<Leaf> leaves = sorted_leaves(grid);
  std::uint64_t blocks = 0;
  for_each_block(leaves, [&](const Cell&, std::span<const Leaf>) { ++blocks; });

  RmapWriter writer(
      file, {.scans = grid.scan_poses().size(), .blocks = blocks, .cells = grid.cell_count()});
  writer.add(wire::kOptions, wire::encoded_options(grid.options()));
  writer.add(wire::kHistory, wire::encoded_history(grid.history()));
  write_poses(writer, grid.scan_poses());
  write_blocks(writer, leaves);
  writer.commit();
}

}  // namespace rmap
