#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <rmap/grid.hpp>

namespace rmap {

/// A file of OctoMap with more cells, large leaves expanded, is refused unless more are asked for.
inline constexpr std::uint64_t kOctomapMaxCells = 100'000'000;

// Files of OctoMap, docs/formats/octomap.md: `.bt` holds the states of an occupancy octree alone,
// `.ot` its log-odds. What reads throws Error(io) when a file cannot be read, Error(input) when it
// is no such file, is cut short, does not hold what its header says or has bytes left over. Which
// of the two it is, its first line says. Cell (i, j, k) is OctoMap's key minus 32768; a leaf of
// OctoMap is occupied when its log-odds is not negative. Never more memory than file and cells
// take.

/// What is in a file of OctoMap.
struct OctomapInfo {
  std::string id;                     ///< type of the tree: OcTree, ColorOcTree, OcTreeStamped
  bool states_only = false;           ///< a `.bt`: no values
  bool colors = false;                ///< with a colour for each node, which is not read
  double resolution = 0;              ///< metres
  std::uint64_t nodes = 0;            ///< inner ones too
  std::uint64_t occupied_leaves = 0;  ///< of any size
  std::uint64_t free_leaves = 0;
  std::uint64_t occupied_cells = 0;  ///< in occupied leaves, large ones expanded
  std::uint64_t free_cells = 0;
  CellBox bounds = {};           ///< of all leaves; empty without any
  CellBox occupied_bounds = {};  ///< of the occupied ones
  float min_log_odds = 0;        ///< of the leaves; 0 with states only or without any leaf
  float max_log_odds = 0;
};

/// Reads a file of OctoMap as a whole, and counts. Cost: its nodes, not its cells.
OctomapInfo read_octomap_info(const std::filesystem::path& file);

/// What is occupied in a map of OctoMap.
struct OctomapCells {
  double resolution = 0;       ///< metres
  std::vector<Cell> occupied;  ///< each once, in Morton order; large leaves expanded
  std::uint64_t occupied_leaves = 0;
  std::uint64_t free_leaves = 0;  ///< dropped: free space is implicit here
};

struct OctomapReadOptions {
  /// A file with more occupied cells, large leaves expanded, is refused.
  std::uint64_t max_cells = kOctomapMaxCells;
};

/// Reads the occupied cells alone. Throws Error(limit) beyond max_cells too.
OctomapCells read_octomap(const std::filesystem::path& file,
                          const OctomapReadOptions& options = {});

struct OctomapImportOptions {
  /// Of the grid. The resolution is the file's: 0, or the same number.
  Options map = {};
  /// A file with more cells to be kept, large leaves expanded, is refused.
  std::uint64_t max_cells = kOctomapMaxCells;
  /// Cells of free leaves become existing cells too; else they are dropped, and count as free
  /// because no cell exists there.
  bool keep_free = false;
};

/// A map of OctoMap as a grid, and what became of its leaves.
///
/// A value is the leaf's log-odds, rounded to the nearest step of 1/1000 that keeps its state, and
/// clamped by the options; of a `.bt` the upper limit where it is occupied, the lower one where
/// it is free, as in OctoMap. The history is first_hit: a file of OctoMap knows of none.
struct OctomapImport {
  Grid grid;
  OctomapInfo file;
  std::uint64_t dropped_free_leaves = 0;
  /// Leaves whose value was beyond the limits of the options.
  std::uint64_t clamped_leaves = 0;
  /// Leaves whose state no value near theirs keeps: the threshold of the options is another one
  /// than OctoMap's, or beyond a limit.
  std::uint64_t changed_leaves = 0;
};

/// Throws as read_octomap, Error(limit) beyond max_cells before any cell is made, and
/// Error(input) when the options do not fit together or name another resolution.
OctomapImport import_octomap(const std::filesystem::path& file,
                             const OctomapImportOptions& options = {});

/// What a grid became as a file of OctoMap, and what that file cannot hold beside the options,
/// the history and the poses of the scans, which are lost in any case.
struct OctomapExport {
  std::uint64_t nodes = 0;           ///< inner ones too
  std::uint64_t occupied_cells = 0;  ///< by the grid's own threshold
  std::uint64_t free_cells = 0;
  /// Cells whose value a `.bt` does not hold: it is not the limit that their state stands for.
  std::uint64_t lost_values = 0;
  /// Cells of a `.ot` that OctoMap's threshold of 0.5 takes for the other state than the grid's.
  std::uint64_t changed_states = 0;
};

/// Writes a grid as OctoMap does, by the ending of `file`: `.bt` or `.ot`, of type OcTree, eight
/// equal leaves pruned to one. Equal cells are equal bytes. Free cells become free leaves; a
/// cell that is free with log-odds 0 gets -0.00025 in a `.ot`, since OctoMap calls 0 occupied.
/// Complete or not at all. Throws Error(limit) for a cell beyond OctoMap's -32768 to 32767,
/// Error(input) for another ending, Error(io). Memory: the file, and 32 bytes a leaf of the grid.
OctomapExport export_octomap(const Grid& grid, const std::filesystem::path& file);

}  // namespace rmap
