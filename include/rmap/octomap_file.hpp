#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// What is occupied in a map of OctoMap.
struct OctomapCells {
  double resolution = 0;       ///< metres
  std::vector<Cell> occupied;  ///< each once, in the order of the file; large leaves expanded
  std::uint64_t occupied_leaves = 0;
  std::uint64_t free_leaves = 0;  ///< dropped: free space is implicit here
};

struct OctomapReadOptions {
  /// A file with more occupied cells, large leaves expanded, is refused.
  std::uint64_t max_cells = 100'000'000;
};

/// Reads a `.bt` file (OcTree, binary states). Cell (i, j, k) is OctoMap's key minus 32768.
/// Throws Error(io) when it cannot be read, Error(input) when it is not such a file, is cut short
/// or has bytes left over, Error(limit) beyond max_cells. Never more memory than the cells and the
/// file take.
OctomapCells read_octomap(const std::filesystem::path& file,
                          const OctomapReadOptions& options = {});

}  // namespace rmap
