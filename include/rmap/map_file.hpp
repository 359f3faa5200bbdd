#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <rmap/grid.hpp>

namespace rmap {

/// How a map is kept and worked on once it is loaded: the options that are no part
/// of the map, and of which a map file therefore says nothing. As in `Options`.
struct LoadOptions {
  /// `cells` takes more memory and time: up to some 800 times the length of the file, where
  /// `blocks` takes up to some 20 times (docs/formats/rmap.md).
  Layout layout = Layout::blocks;
  int max_branches = 32;
  Split split = Split::quadratic;
  BadPoints bad_points = BadPoints::skip;
  Traversal traversal = Traversal::automatic;
  int threads = 1;
};

/// Writes a map to a `.rmap` file: resolution, the options that bear on values, the
/// cells, the history and the poses of the scans; docs/formats/rmap.md describes it.
/// Equal maps (`same_map`) are equal bytes, with one release of zstd. Complete or not
/// at all: on Error(io), for a full disk say, a former file is untouched. Throws
/// Error(input) when a pose of the grid is none. Memory: some 20 MB, and 32 bytes a leaf.
void save(const Grid& grid, const std::filesystem::path& file);

/// Reads what `save` wrote: the same map. The file may come from a stranger: every
/// flipped bit, cut and addition is noticed, and memory is bounded by its length, by a
/// factor that the layout decides.
/// Throws Error(input) when the content is not a sound map or needs a newer release,
/// or when `options` do not fit together; Error(io) when it cannot be read.
Grid load(const std::filesystem::path& file, const LoadOptions& options = {});

/// A part of a map file.
struct MapChunk {
  std::string type;      ///< OPTS, HIST, POSE, CELL, END, or one that this release does not know
  bool required;         ///< whether a reader that does not know it must give up
  bool compressed;       ///< by zstd
  std::uint64_t offset;  ///< of its first byte in the file
  std::uint64_t stored_size;  ///< bytes of its content in the file
  std::uint64_t raw_size;     ///< bytes of its content once decompressed
};

/// What a map file says of itself.
struct MapFileInfo {
  std::uint32_t format_version = 0;
  std::uint64_t file_size = 0;  ///< bytes
  /// The options that are part of the map; the others have their defaults.
  Options options = {};
  History history = History::first_hit;
  std::uint64_t scans = 0;            ///< poses of inserted scans
  std::uint64_t blocks = 0;           ///< aligned blocks of 8 x 8 x 8 cells with a cell in them
  std::uint64_t cells = 0;            ///< existing cells
  std::vector<MapChunk> chunks = {};  ///< in the order of the file
};

/// Reads a map file without decoding its cells and poses; all its checksums are
/// verified all the same. Throws as `load`. Cost: one pass over the file's bytes.
MapFileInfo read_map_info(const std::filesystem::path& file);

}  // namespace rmap
