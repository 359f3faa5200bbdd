#include "io/input_file.hpp"
#include "io/memory.hpp"
#include "io/rmap_blocks.hpp"
#include "io/rmap_content.hpp"
#include "io/rmap_reader.hpp"
#include "io/rmap_records.hpp"
#include "io/rmap_salvage.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <rmap/error.hpp>
#include <rmap/map_file.hpp>
#include <rmap/map_repair.hpp>

namespace rmap {

namespace {

/// Makes a map of the chunks that are sound.
class Repair {
 public:
  Repair(const std::filesystem::path& file, Salvage salvage)
      : file_(file), salvage_(std::move(salvage)), problems_(std::move(salvage_.problems)) {}

  /// What is wrong, with chunks whose content is, and counts that are not met.
  std::vector<MapProblem> problems() && {
    decode_records();
    Grid grid(options_.value_or(Options{.resolution = 1}));
    decode_cells(grid);
    require_counts();
    return std::move(problems_);
  }

  MapRepair map(const MapRepairOptions& wanted) && {
    decode_records();
    const bool options_lost = !options_;
    MapRepair repair{.grid = Grid(options_for(wanted)), .options_lost = options_lost};
    decode_cells(repair.grid);
    require_counts();
    const bool complete = all_cells_are_there();
    repair.history_lost = !history_ || !complete;
    repair.salvaged = {.scans = poses_.size(), .blocks = blocks_, .cells = cells_};
    if (const auto& header = salvage_.header) {
      repair.announced = {.scans = header->scans, .blocks = header->blocks, .cells = header->cells};
    }
    repair.grid.restore(repair.history_lost ? History::first_hit : *history_, std::move(poses_));
    repair.grid.repack();
    repair.problems = std::move(problems_);
    return repair;
  }

 private:
  // decode(chunk, content) for each chunk of a type; a content that is wrong is a problem.
  template <class Decode>
  void for_each(const wire::ChunkType& type, Decode&& decode) {
    for (const SoundChunk& chunk : salvage_.chunks) {
      if (chunk.header.type != type || chunk.header.version > wire::kFormatVersion) continue;
      try {
        decode(chunk, decoder_.decode(chunk.header, chunk.stored));
      } catch (const Error& error) {
        problem(chunk, fmt::format("{}: {} {}", file_.string(), chunk.place(), error.what()));
      }
    }
  }

  void problem(const SoundChunk& chunk, std::string sentence) {
    problems_.push_back(
        {.sentence = std::move(sentence),
         .chunk = wire::name_of(chunk.header.type),
         .offset = chunk.offset,
         .size = wire::kChunkHeaderSize + chunk.stored.size() + wire::kChecksumSize});
  }

  void decode_records() {
    for_each(wire::kOptions, [&](const SoundChunk&, std::span<const std::byte> content) {
      const Options options = wire::decoded_options(content);
      if (!options_) options_ = options;
    });
    for_each(wire::kHistory, [&](const SoundChunk&, std::span<const std::byte> content) {
      history_ = wire::decoded_history(content);
    });
    for_each(wire::kPoses, [&](const SoundChunk& chunk, std::span<const std::byte> content) {
      std::vector<Pose> poses;
      wire::decode_poses(content, chunk.header.stored_size, poses);
      poses_.insert(poses_.end(), poses.begin(), poses.end());
    });
    for (const SoundChunk& chunk : salvage_.chunks) refuse_if_new(chunk);
  }

  // What a newer release made a part of the map is lost here.
  void refuse_if_new(const SoundChunk& chunk) {
    constexpr std::array kKnown = {wire::kOptions, wire::kHistory, wire::kPoses, wire::kCells,
                                   wire::kEnd};
    const bool known = chunk.header.version <= wire::kFormatVersion &&
                       std::find(kKnown.begin(), kKnown.end(), chunk.header.type) != kKnown.end();
    if (known || !chunk.header.required()) return;
    problem(chunk,
            fmt::format("{}: {} is required but not known: it needs version {} of the rmap "
                        "format, and this release of rmap knows version {}",
                        file_.string(), chunk.place(), chunk.header.version, wire::kFormatVersion));
  }

  void decode_cells(Grid& grid) {
    std::optional<Cell> last;
    for_each(wire::kCells, [&](const SoundChunk& chunk, std::span<const std::byte> content) {
      // Each on its own: what a damaged one left behind does not matter to the next.
      wire::BlockDecoder decoder;
      const auto blocks = decoder.decode(content, chunk.header.stored_size);
      if (last && !morton_less(*last, blocks.front().origin)) {
        throw Error(ErrorKind::input, "repeats blocks or is out of order, and is left out");
      }
      grid.set_blocks(blocks);
      last = blocks.back().origin;
      blocks_ += decoder.blocks();
      cells_ += decoder.cells();
    });
  }

  void require_counts() {
    if (!salvage_.header) return;
    const auto require = [&](std::uint64_t found, std::uint64_t announced, const char* things) {
      if (found == announced) return;
      problems_.push_back(
          {.sentence = fmt::format("{} holds {} {} that are sound, but its header announces {}",
                                   file_.string(), found, things, announced)});
    };
    require(poses_.size(), salvage_.header->scans, "scan poses");
    require(blocks_, salvage_.header->blocks, "blocks");
    require(cells_, salvage_.header->cells, "cells");
  }

  bool all_cells_are_there() const {
    if (salvage_.header) {
      return blocks_ == salvage_.header->blocks && cells_ == salvage_.header->cells;
    }
    // Without its counts: nothing is missing between the chunks when END counts them.
    return !salvage_.chunks.empty() && salvage_.chunks.back().header.type == wire::kEnd &&
           salvage_.chunks.back().stored.size() == sizeof(std::uint64_t) &&
           load_little<std::uint64_t>(salvage_.chunks.back().stored.data()) ==
               salvage_.chunks.size() - 1;
  }

  Options options_for(const MapRepairOptions& wanted) const {
    if (!options_ && !wanted.resolution) {
      throw Error(
          ErrorKind::input,
          fmt::format("{} has lost its options, chunk OPTS, and without them its cells mean "
                      "nothing: give the resolution that it was made with (--resolution) "
                      "to salvage it with default options",
                      file_.string()));
    }
    if (!options_) return {.resolution = *wanted.resolution};
    if (wanted.resolution && *wanted.resolution != options_->resolution) {
      throw Error(ErrorKind::input,
                  fmt::format("{} has a resolution of {} m by its options, which are sound, not {} "
                              "m",
                              file_.string(), options_->resolution, *wanted.resolution));
    }
    return *options_;
  }

  const std::filesystem::path& file_;
  Salvage salvage_;
  std::vector<MapProblem> problems_;
  wire::ContentDecoder decoder_;
  std::optional<Options> options_;
  std::optional<History> history_;
  std::vector<Pose> poses_;
  std::uint64_t blocks_ = 0;
  std::uint64_t cells_ = 0;
};

// Throws what `load` would for files that are none of this kind or version.
Salvage salvage_map(const std::filesystem::path& file, std::span<const std::byte> bytes) {
  Salvage found = salvage(file, bytes);
  const bool none = found.chunks.empty() && !found.header;
  const bool other_version = found.header && found.header->version != wire::kFormatVersion;
  if (none || other_version) RmapReader reader(file);
  return found;
}

std::vector<std::byte> bytes_of(const std::filesystem::path& file) {
  InputFile input(file);
  return input.read_rest();
}

}  // namespace

std::vector<MapProblem> check_map_file(const std::filesystem::path& file) {
  return with_memory_for(file, [&]() -> std::vector<MapProblem> {
    std::string first;
    try {
      load(file);
      return {};
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::input) throw;
      first = error.what();
    }
    const std::vector<std::byte> bytes = bytes_of(file);
    try {
      auto problems = Repair(file, salvage_map(file, bytes)).problems();
      if (!problems.empty()) return problems;
    } catch (const Error&) {
      // No map file at all: the first problem says so.
    }
    return {{.sentence = first}};
  });
}

MapRepair repair_map(const std::filesystem::path& file, const MapRepairOptions& options) {
  return with_memory_for(file, [&] {
    const std::vector<std::byte> bytes = bytes_of(file);
    return Repair(file, salvage_map(file, bytes)).map(options);
  });
}

}  // namespace rmap
