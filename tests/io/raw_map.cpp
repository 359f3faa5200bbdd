#include "io/raw_map.hpp"

#include "io/files.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>

#include <xxhash.h>
#include <zstd.h>

namespace rmap::test {

namespace {

constexpr std::size_t kHeader = 40;
constexpr std::size_t kChunkHeader = 24;
constexpr std::size_t kChecksum = 8;
constexpr std::size_t kBlocksPerChunk = 4096;
constexpr std::size_t kPosesPerChunk = 32768;

template <class T>
T number_at(const std::string& bytes, std::size_t offset) {
  T number{};
  bytes.copy(reinterpret_cast<char*>(&number), sizeof(T), offset);
  return number;
}

// -0 and +0 are the same number, so only one of them is written.
std::string number_bytes(double number) { return raw(number == 0 ? 0.0 : number); }

std::string options_bytes(const Options& options) {
  std::string bytes;
  for (const double number :
       {options.resolution, options.prob_hit, options.prob_miss, options.clamp_min,
        options.clamp_max, options.prior, options.occupied_threshold, options.free_probability,
        options.min_range, options.max_range}) {
    bytes += number_bytes(number);
  }
  bytes += raw<std::uint32_t>(options.saturation == Saturation::freeze ? 1 : 0);
  bytes += raw<std::uint32_t>(options.beams == Beams::per_end_cell ? 1 : 0);
  return bytes;
}

struct Block {
  Cell origin;
  std::array<unsigned char, 64> mask = {};
  std::vector<Value> values = {};
};

std::vector<Block> blocks_of(const Grid& grid) {
  std::vector<CellValue> cells;
  grid.visit_leaves(all_cells(), [&](const Leaf& leaf) {
    leaf.for_each([&](const Cell& cell, Value value) { cells.push_back({cell, value}); });
    return true;
  });
  std::sort(cells.begin(), cells.end(),
            [](const CellValue& a, const CellValue& b) { return morton_less(a.cell, b.cell); });
  std::vector<Block> blocks;
  for (const auto& [cell, value] : cells) {
    const Cell origin = cell.unaryExpr([](int i) { return i - ((i % 8) + 8) % 8; });
    if (blocks.empty() || blocks.back().origin != origin) blocks.push_back({.origin = origin});
    // Bits of the offsets by turns, x first.
    std::size_t position = 0;
    for (std::size_t bit = 0; bit < 9; ++bit) {
      const int offset = (cell - origin)[static_cast<int>(bit % 3)];
      position |= static_cast<std::size_t>(offset >> (bit / 3) & 1) << bit;
    }
    blocks.back().mask[position / 8] |= static_cast<unsigned char>(1 << position % 8);
    blocks.back().values.push_back(value);
  }
  return blocks;
}

std::string cells_bytes(const std::vector<Block>& blocks) {
  std::string indices;
  for (int axis = 0; axis < 3; ++axis) {
    std::array<std::string, 4> planes;
    std::int64_t before = 0;
    for (const Block& block : blocks) {
      const std::int64_t index = block.origin[axis] / 8;
      const std::int64_t step = index - before;
      const std::int64_t zigzag = step < 0 ? -2 * step - 1 : 2 * step;
      for (std::size_t plane = 0; plane < 4; ++plane) {
        planes[plane] += static_cast<char>(zigzag >> (8 * plane) & 255);
      }
      before = index;
    }
    for (const std::string& plane : planes) indices += plane;
  }
  std::string summaries;
  std::string masks;
  std::string values;
  std::uint32_t cells = 0;
  for (const Block& block : blocks) {
    for (std::size_t word = 0; word < 8; ++word) {
      int summary = 0;
      for (std::size_t i = 0; i < 8; ++i) {
        const unsigned char byte = block.mask[8 * word + i];
        if (byte == 0) continue;
        summary |= 1 << i;
        masks += static_cast<char>(byte);
      }
      summaries += static_cast<char>(summary);
    }
    for (const Value value : block.values) values += raw(value);
    cells += static_cast<std::uint32_t>(block.values.size());
  }
  return raw(static_cast<std::uint32_t>(blocks.size())) + raw(cells) + indices + summaries + masks +
         values;
}

}  // namespace

RawChunk raw_chunk(const std::string& type, const std::string& content) {
  return {.type = type, .stored = content, .raw_size = content.size()};
}

RawChunk& RawMap::chunk(const std::string& type) {
  for (RawChunk& chunk : chunks) {
    if (chunk.type == type) return chunk;
  }
  throw std::out_of_range("no chunk " + type);
}

std::string bytes_of(const RawMap& map) {
  std::string bytes = "\x89RMAP\r\n\n" + raw(map.version) + raw<std::uint32_t>(0) + raw(map.scans) +
                      raw(map.blocks) + raw(map.cells);
  std::size_t covered_from = 0;
  const auto seal = [&] {
    const std::uint64_t checksum =
        XXH3_64bits(bytes.data() + covered_from, bytes.size() - covered_from);
    covered_from = bytes.size();
    bytes += raw(checksum);
  };
  seal();
  for (const RawChunk& chunk : map.chunks) {
    bytes += chunk.type + raw(chunk.flags) + raw(chunk.version) + raw(chunk.raw_size) +
             raw<std::uint64_t>(chunk.stored.size()) + chunk.stored;
    seal();
  }
  return bytes;
}

RawMap parsed(const std::string& bytes) {
  RawMap map{.scans = number_at<std::uint64_t>(bytes, 16),
             .blocks = number_at<std::uint64_t>(bytes, 24),
             .cells = number_at<std::uint64_t>(bytes, 32),
             .version = number_at<std::uint32_t>(bytes, 8)};
  for (std::size_t offset = kHeader + kChecksum; offset < bytes.size();) {
    const auto stored_size = number_at<std::uint64_t>(bytes, offset + 16);
    map.chunks.push_back({.type = bytes.substr(offset, 4),
                          .stored = bytes.substr(offset + kChunkHeader, stored_size),
                          .raw_size = number_at<std::uint64_t>(bytes, offset + 8),
                          .flags = number_at<std::uint16_t>(bytes, offset + 4),
                          .version = number_at<std::uint16_t>(bytes, offset + 6)});
    offset += kChunkHeader + stored_size + kChecksum;
  }
  return map;
}

RawMap decompressed(RawMap map) {
  for (RawChunk& chunk : map.chunks) {
    if ((chunk.flags & 2) == 0) continue;
    const std::size_t frame =
        ZSTD_findFrameCompressedSize(chunk.stored.data(), chunk.stored.size());
    std::string content(chunk.raw_size, '\0');
    if (ZSTD_decompress(content.data(), content.size(), chunk.stored.data(), frame) !=
        content.size()) {
      throw std::runtime_error("chunk " + chunk.type + " does not decompress");
    }
    chunk.stored = content;
    chunk.flags = static_cast<std::uint16_t>(chunk.flags & ~2);
  }
  return map;
}

RawMap raw_map(const Grid& grid) {
  const std::vector<Block> blocks = blocks_of(grid);
  RawMap map{
      .scans = grid.scan_poses().size(), .blocks = blocks.size(), .cells = grid.cell_count()};
  map.chunks.push_back(raw_chunk("OPTS", options_bytes(grid.options())));
  map.chunks.push_back(
      raw_chunk("HIST", raw<std::uint32_t>(grid.history() == History::complete ? 1 : 0)));
  std::string poses;
  for (const Pose& pose : grid.scan_poses()) {
    poses += pose_bytes(pose);
    if (poses.size() < 96 * kPosesPerChunk) continue;
    map.chunks.push_back(raw_chunk("POSE", poses));
    poses.clear();
  }
  if (!poses.empty()) map.chunks.push_back(raw_chunk("POSE", poses));
  for (std::size_t first = 0; first < blocks.size(); first += kBlocksPerChunk) {
    const std::size_t last = std::min(blocks.size(), first + kBlocksPerChunk);
    map.chunks.push_back(
        raw_chunk("CELL", cells_bytes({blocks.begin() + static_cast<std::ptrdiff_t>(first),
                                       blocks.begin() + static_cast<std::ptrdiff_t>(last)})));
  }
  map.chunks.push_back(raw_chunk("END ", raw<std::uint64_t>(map.chunks.size())));
  return map;
}

std::string pose_bytes(const Pose& pose) {
  std::string bytes;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) bytes += number_bytes(pose(row, column));
  }
  return bytes;
}

std::string zstd_frame(const std::string& content) {
  std::string frame(ZSTD_compressBound(content.size()), '\0');
  frame.resize(ZSTD_compress(frame.data(), frame.size(), content.data(), content.size(), 3));
  return frame;
}

}  // namespace rmap::test
