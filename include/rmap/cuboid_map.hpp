#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <rmap/changes.hpp>
#include <rmap/counted_cells.hpp>
#include <rmap/cuboids.hpp>
#include <rmap/grid.hpp>
#include <rmap/rtree.hpp>

namespace rmap {

struct CuboidMapOptions {
  int outer = 1;    ///< A, as in ApproximationOptions
  int inner = 0;    ///< B
  int threads = 1;  ///< for the first approximation
  /// Of the R-tree that the cuboids are kept in [RMAP 2.3].
  RTreeOptions rtree = {};
};

/// The cuboids of a map that changes, in an R-tree: after a change only those around it are found
/// anew, with the same guarantee as from the start: every occupied cell is at most `inner` cells
/// from a cuboid, every empty cell of a cuboid at most `outer` cells from an occupied one.
class CuboidMap {
 public:
  /// Throws Error(input) when an option is out of range.
  explicit CuboidMap(std::span<const CountedCell> cells, const CuboidMapOptions& options = {});
  /// Of the occupied cells of a grid, as it is at its revision.
  explicit CuboidMap(const Grid& grid, const CuboidMapOptions& options = {});
  ~CuboidMap();
  CuboidMap(CuboidMap&&) noexcept;
  CuboidMap& operator=(CuboidMap&&) noexcept;

  /// Takes over what a grid tells of its changes, as Grid::changes_since gives them for the
  /// revision of the last call; `now` is the grid's revision then. Cost: some milliseconds for a
  /// change of a small region, by its cells and those at most 24 cells around; a change that
  /// reaches far is cut into regions. Throws Error(usage) when the changes begin after revision(),
  /// Error(limit) for a cell beyond the limits; the cuboids then stay as they were.
  void update(const Changes& changes);
  /// The same for cells and whether they are occupied now.
  void update(std::span<const CellState> cells);
  /// The grid's revision that the cuboids stand for.
  std::uint64_t revision() const;

  std::size_t size() const;
  std::size_t cell_count() const;
  /// Occupied cells, by z, then y, then x.
  std::vector<CountedCell> cells() const;
  /// The cuboids, in no order; points: their occupied cells.
  std::vector<Cuboid> cuboids() const;
  /// The R-tree of the cuboids, for queries; its payloads mean nothing outside.
  const RTree<std::uint32_t>& tree() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace rmap
