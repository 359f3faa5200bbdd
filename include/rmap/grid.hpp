#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <rmap/changes.hpp>
#include <rmap/function_ref.hpp>
#include <rmap/lattice.hpp>
#include <rmap/leaf.hpp>
#include <rmap/report.hpp>
#include <rmap/scan.hpp>

namespace rmap {

/// What a grid knows of a place.
enum class State : std::uint8_t {
  occupied,      ///< the cell's probability is above the threshold
  free,          ///< the cell exists and is not occupied: beams ended in it and crossed it
  assumed_free,  ///< the cell does not exist: the free-space assumption; nobody may have looked
};

/// Which misses the cells have seen.
enum class History : std::uint8_t {
  first_hit,  ///< those since a cell's first hit: the paper's single pass, a live robot's
  complete,   ///< all of them: every cell existed before the first scan was inserted
};

/// A probabilistic occupancy grid with implicit free space, in an R-tree [RMAP 2.2].
///
/// All space is free until a beam ends in it: only cells in which a beam ended
/// exist, and only those are updated and take memory. Memory follows the
/// surfaces seen, not the volume.
///
/// The map does not depend on the order of the points in a scan, the number of
/// threads, the layout in memory or the machine: equal input, equal values.
///
/// const functions are safe beside one another; a writer needs the grid to
/// itself. A copy is an independent snapshot, at the cost of copying its bytes.
/// A moved-from grid may only be assigned to or destroyed.
class Grid {
 public:
  /// Throws Error(input) naming the field when the options do not fit together.
  explicit Grid(const Options& options);
  Grid(const Grid& other);
  Grid(Grid&& other) noexcept;
  Grid& operator=(const Grid& other);
  Grid& operator=(Grid&& other) noexcept;
  ~Grid();

  const Options& options() const;
  const Lattice& lattice() const;
  const UpdateRule& rule() const;

  // --- Scans -----------------------------------------------------------------

  /// Updates the map with a scan: every end cell is hit once (and made where it
  /// is new), every other existing cell that a beam crosses is missed once.
  /// Throws, with the grid as it was: Error(input) when the pose is no pose or
  /// `origins` does not fit the points; Error(limit) when the sensor is beyond
  /// the limits, or a point is and `bad_points` is error.
  /// Cost: by points, and by existing blocks near the beams; never by free space.
  InsertReport insert(const Scan& scan);

  /// Makes the end cells of a scan exist at the prior, without hitting them.
  /// Preparing with every scan before the first is inserted gives each cell its
  /// complete history: the cure for misses before a cell's first hit, which the
  /// free-space assumption otherwise loses. Same filters and errors as `insert`.
  PrepareReport prepare(const Scan& scan);

  /// complete when no cell was made after the first insertion had begun.
  History history() const;
  /// Poses of the inserted scans, in order (for scans in the map's frame, the origin).
  std::span<const Pose> scan_poses() const;

  // --- Places ----------------------------------------------------------------

  /// State at a point (m). Throws Error(limit) beyond the limits.
  State state(const Vector3d& point) const;
  State cell_state(const Cell& cell) const;
  /// Probability at a point (m): free_probability where no cell exists. Throws Error(limit).
  double point_probability(const Vector3d& point) const;
  double cell_probability(const Cell& cell) const;
  /// Log-odds of a cell, or nothing where it does not exist.
  std::optional<Value> cell_value(const Cell& cell) const;

  // --- The whole -------------------------------------------------------------

  std::size_t cell_count() const;
  bool empty() const { return cell_count() == 0; }
  /// Smallest box that holds every existing cell; empty when there is none. Cost: by leaves.
  CellBox bounds() const;
  /// Smallest box of whole blocks (8 x 8 x 8 cells, in both layouts) that holds every existing
  /// cell; empty when there is none. Cost: constant.
  CellBox block_bounds() const;
  BytesInUse bytes_in_use() const;
  RTreeStatistics rtree_statistics() const;
  std::size_t leaf_count() const;

  // --- Leaves: how algorithms read a grid ------------------------------------

  /// The leaf branches that overlap `region`, in no order. A leaf on the border
  /// has cells outside too. `visit` returns false to stop.
  void visit_leaves(const CellBox& region, FunctionRef<bool(const Leaf&)> visit) const;
  /// The leaf branches that `beam` crosses, roughly from front to back. `visit` gets the
  /// parameter of entry and returns the one from which on nothing is wanted any more.
  void visit_leaves_along(const Beam& beam,
                          FunctionRef<double(const Leaf&, double enter)> visit) const;

  // --- Change ----------------------------------------------------------------

  /// Sets the probability of a cell, in [0, 1], clamped by the options; makes the cell where
  /// it is new. Throws Error(input), Error(limit).
  void set(const Cell& cell, double probability);
  /// Makes a cell hold `value` as it is, without clamping. Throws Error(limit).
  void set_value(const Cell& cell, Value value);
  /// The same for the cells of many blocks, which come in Morton order, each once: a map
  /// that was built elsewhere costs far less so. Throws Error(input) when a block does not
  /// start at multiples of 8, lacks a value or is out of order, Error(limit); the grid then
  /// stays as it was.
  void set_blocks(std::span<const BlockValues> blocks);
  /// Takes over the records of a map that was built elsewhere: how a file is read.
  /// Throws Error(input) when a pose is none.
  void restore(History history, std::vector<Pose> scan_poses);
  /// Packs the nodes of the R-tree full: less memory and less overlap. The map stays the same.
  /// Memory of erased cells waits for new ones; saving and loading gives it back.
  void repack();
  /// Removes the cells in a box (m; borders as in Lattice::cells_of) and returns how many.
  std::size_t erase(const Box& box);
  std::size_t erase_cells(const CellBox& cells);
  /// Removes the cells with a probability at or below `probability` and returns
  /// how many: they count as free either way, but forget that they were seen.
  std::size_t prune(double probability);
  /// Adds what another map knows: a + b - prior, then clamp by this grid's
  /// options; a cell that only one map has keeps its value. Throws Error(input)
  /// unless resolution and prior are equal. A grid may be merged with itself.
  void merge(const Grid& other);

  /// Rises with every mutation. 0: nothing happened yet.
  std::uint64_t revision() const;
  /// Remembers the last `cells` flips between occupied and not, from now on; 0: none.
  void track_flips(std::size_t cells);
  /// What changed after `since`. Throws Error(usage) when `since` is in the future.
  Changes changes_since(std::uint64_t since) const;

  /// Nothing when the grid is sound; else a sentence that says what is not.
  std::optional<std::string> check() const;

 private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// Whether two grids are the same map: resolution, the options that bear on
/// values, the cells with their values, history and scan poses. Layout, order
/// of the R-tree and threads do not matter.
bool same_map(const Grid& a, const Grid& b);

}  // namespace rmap
