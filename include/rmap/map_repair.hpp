#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <rmap/grid.hpp>

namespace rmap {

/// A part of a map file that is not as it must be.
struct MapProblem {
  std::string sentence;  ///< complete: file, place, what is wrong
  /// Type of the chunk, as in MapChunk; empty where there is none to be seen.
  std::string chunk = {};
  /// First byte of the part and its length; nothing for the file as a whole.
  std::optional<std::uint64_t> offset = {};
  std::uint64_t size = 0;
};

/// All that is wrong with a `.rmap` file, in the order of the file, where `load` tells the first
/// problem only. Empty exactly when `load` takes the file. Throws Error(io) when it cannot be read.
/// Memory: the file and the map.
std::vector<MapProblem> check_map_file(const std::filesystem::path& file);

struct MapRepairOptions {
  /// Edge of a cell (m) in case the options of the map are lost, which then have their defaults.
  std::optional<double> resolution = {};
};

/// What a map file held.
struct MapCounts {
  std::uint64_t scans = 0;
  std::uint64_t blocks = 0;
  std::uint64_t cells = 0;
};

/// What could be salvaged of a map file.
struct MapRepair {
  Grid grid;
  /// Empty when the file was sound.
  std::vector<MapProblem> problems = {};
  MapCounts salvaged = {};
  /// By the file's header; nothing when that is lost.
  std::optional<MapCounts> announced = {};
  /// Options other than the resolution given are the defaults.
  bool options_lost = false;
  /// The history is first_hit because its chunk, or cells, are lost.
  bool history_lost = false;
};

/// Salvages what is intact of a `.rmap` file: each chunk that its checksum confirms, with the
/// checksum before it as it stands there or as it follows from the chunk before. Behind damage,
/// bytes lost or bytes added, it looks for the next such chunk. The file stays as it is.
/// Throws Error(input) when it is no map file, or of another version; when the options are lost
/// and no resolution is given, since the cells mean nothing without; when a resolution is given
/// and the options say another one. Throws Error(io) when it cannot be read. Memory: the file and
/// the map. Time: bounded by the file's length.
MapRepair repair_map(const std::filesystem::path& file, const MapRepairOptions& options = {});

}  // namespace rmap
