#include "io/memory.hpp"
#include "io/rmap_blocks.hpp"
#include "io/rmap_reader.hpp"
#include "io/rmap_records.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/map_file.hpp>

namespace rmap {

namespace {

using Chunk = RmapReader::Chunk;

// The chunks that this release knows, in the order in which they must come.
constexpr std::array kOrder = {wire::kOptions, wire::kHistory, wire::kPoses, wire::kCells,
                               wire::kEnd};

// Place of a chunk's type in the order; its size for one that this release does not know.
std::size_t rank_of(const wire::ChunkHeader& header) {
  if (header.version > wire::kFormatVersion) return kOrder.size();
  return static_cast<std::size_t>(std::find(kOrder.begin(), kOrder.end(), header.type) -
                                  kOrder.begin());
}

bool may_repeat(const wire::ChunkType& type) {
  return type == wire::kPoses || type == wire::kCells;
}

// One pass over the chunks of a map file.
class Walk {
 public:
  explicit Walk(const std::filesystem::path& file) : reader_(file) {}

  RmapReader& reader() { return reader_; }
  /// All chunks so far, those that were passed over too.
  const std::vector<Chunk>& chunks() const { return chunks_; }

  /// The next chunk whose content must be read or skipped; nothing at the sound end.
  std::optional<Chunk> next() {
    for (;;) {
      const Chunk chunk = reader_.next();
      chunks_.push_back(chunk);
      if (rank_of(chunk.header) == kOrder.size()) {
        pass_over(chunk);
        continue;
      }
      check_order(chunk);
      if (chunk.header.type != wire::kEnd) return chunk;
      reader_.finish(chunk);
      return std::nullopt;
    }
  }

 private:
  // The checksum comes first: a flipped bit in a type is damage, and nothing new.
  void pass_over(const Chunk& chunk) {
    reader_.skip(chunk);
    if (!chunk.header.required()) return;
    throw reader_.error(chunk, fmt::format("is required but not known: it needs version {} of the "
                                           "rmap format, and this release of rmap knows version {}",
                                           chunk.header.version, wire::kFormatVersion));
  }

  void check_order(const Chunk& chunk) {
    const std::size_t rank = rank_of(chunk.header);
    const bool repeated = rank + 1 == next_rank_ && may_repeat(kOrder[rank]);
    if (rank < next_rank_ && !repeated) {
      throw reader_.error(chunk,
                          "is out of order: OPTS, HIST, POSE, CELL and END must come in "
                          "this order, and only POSE and CELL may be missing or repeated");
    }
    for (; next_rank_ < rank; ++next_rank_) {
      if (may_repeat(kOrder[next_rank_])) continue;
      throw reader_.error(chunk, fmt::format("comes before chunk {}, which must come first",
                                             wire::name_of(kOrder[next_rank_])));
    }
    next_rank_ = rank + 1;
  }

  RmapReader reader_;
  std::vector<Chunk> chunks_;
  std::size_t next_rank_ = 0;
};

// decode(content of the chunk), whose errors are completed with file and chunk.
template <class Decode>
auto decoded(RmapReader& reader, const Chunk& chunk, Decode&& decode) {
  const std::span<const std::byte> content = reader.read(chunk);
  try {
    return decode(content);
  } catch (const Error& error) {
    throw reader.error(chunk, error.what());
  }
}

Options read_options(RmapReader& reader, const Chunk& chunk) {
  return decoded(reader, chunk, wire::decoded_options);
}

void read_poses(RmapReader& reader, const Chunk& chunk, std::vector<Pose>& poses) {
  decoded(reader, chunk, [&](std::span<const std::byte> content) {
    wire::decode_poses(content, chunk.header.stored_size, poses);
  });
}

void require_count(const RmapReader& reader, std::uint64_t found, std::uint64_t announced,
                   std::string_view things) {
  if (found == announced) return;
  throw Error(ErrorKind::input, fmt::format("{} holds {} {}, but its header announces {}",
                                            reader.path().string(), found, things, announced));
}

Grid empty_grid(Options options, const LoadOptions& in_memory) {
  options.layout = in_memory.layout;
  options.max_branches = in_memory.max_branches;
  options.split = in_memory.split;
  options.bad_points = in_memory.bad_points;
  options.threads = in_memory.threads;
  options.traversal = in_memory.traversal;
  return Grid(options);
}

Grid loaded(const std::filesystem::path& file, const LoadOptions& options) {
  Walk walk(file);
  RmapReader& reader = walk.reader();
  std::optional<Grid> grid;
  History history = History::first_hit;
  std::vector<Pose> poses;
  // As many as announced, but not more than a file of this length can hold.
  poses.reserve(static_cast<std::size_t>(
      std::min(reader.header().scans, reader.file_size() / wire::least_size_of_poses(1))));
  wire::BlockDecoder blocks;

  while (const auto chunk = walk.next()) {
    const wire::ChunkType& type = chunk->header.type;
    if (type == wire::kOptions) {
      grid.emplace(empty_grid(read_options(reader, *chunk), options));
    } else if (type == wire::kHistory) {
      history = decoded(reader, *chunk, wire::decoded_history);
    } else if (type == wire::kPoses) {
      read_poses(reader, *chunk, poses);
    } else {
      decoded(reader, *chunk, [&](std::span<const std::byte> content) {
        grid->set_blocks(blocks.decode(content, chunk->header.stored_size));
      });
    }
  }
  require_count(reader, poses.size(), reader.header().scans, "scan poses");
  require_count(reader, blocks.blocks(), reader.header().blocks, "blocks");
  require_count(reader, blocks.cells(), reader.header().cells, "cells");
  grid->restore(history, std::move(poses));
  grid->repack();
  return std::move(*grid);
}

}  // namespace

Grid load(const std::filesystem::path& file, const LoadOptions& options) {
  return with_memory_for(file, [&] { return loaded(file, options); });
}

MapFileInfo read_map_info(const std::filesystem::path& file) {
  Walk walk(file);
  RmapReader& reader = walk.reader();
  MapFileInfo info{.format_version = reader.header().version,
                   .file_size = reader.file_size(),
                   .scans = reader.header().scans,
                   .blocks = reader.header().blocks,
                   .cells = reader.header().cells};
  while (const auto chunk = walk.next()) {
    const wire::ChunkType& type = chunk->header.type;
    if (type == wire::kOptions) {
      info.options = read_options(reader, *chunk);
    } else if (type == wire::kHistory) {
      info.history = decoded(reader, *chunk, wire::decoded_history);
    } else {
      reader.skip(*chunk);
    }
  }
  for (const Chunk& chunk : walk.chunks()) {
    info.chunks.push_back({.type = wire::name_of(chunk.header.type),
                           .required = chunk.header.required(),
                           .compressed = chunk.header.compressed(),
                           .offset = chunk.offset,
                           .stored_size = chunk.header.stored_size,
                           .raw_size = chunk.header.raw_size});
  }
  return info;
}

}  // namespace rmap
