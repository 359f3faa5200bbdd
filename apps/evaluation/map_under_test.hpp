#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/grid.hpp>
#include <rmap/scan.hpp>

namespace rmap::evaluation {

/// A map that the experiments make and ask, whoever wrote it. Scans are in the map's frame, with
/// float32 points and origins, so that all maps work on the same numbers.
class MapUnderTest {
 public:
  MapUnderTest() = default;
  MapUnderTest(const MapUnderTest&) = delete;
  MapUnderTest& operator=(const MapUnderTest&) = delete;
  virtual ~MapUnderTest() = default;

  /// For every scan before the first is inserted, where a complete history is wanted.
  virtual void prepare(const Scan& /*scan*/) {}
  virtual void insert(const Scan& scan) = 0;

  /// Goes over all occupied cells, which is what the paper's extraction time is of; their number.
  virtual std::size_t extract() const = 0;
  /// Nothing where the map holds nothing of the cell.
  virtual std::optional<double> probability(const Cell& cell) const = 0;
  /// In Morton order.
  virtual std::vector<Cell> occupied_cells() const = 0;
};

/// A map of rmap.
class RmapMap : public MapUnderTest {
 public:
  RmapMap(const Options& options, History history) : grid_(options), history_(history) {}

  void prepare(const Scan& scan) override;
  void insert(const Scan& scan) override;
  std::size_t extract() const override;
  std::optional<double> probability(const Cell& cell) const override;
  std::vector<Cell> occupied_cells() const override;

  const Grid& grid() const { return grid_; }
  History wanted_history() const { return history_; }

 private:
  Grid grid_;
  History history_;
};

/// Nodes of an octree, and what they take by the paper's formula [RMAP 3.2].
struct OctreeNodes {
  std::uint64_t inner = 0;
  std::uint64_t leaf = 0;

  std::uint64_t bytes() const { return 80 * inner + 16 * leaf; }
};

/// A map of OctoMap, which prunes as it goes.
class OctomapMap : public MapUnderTest {
 public:
  /// The tree in the three forms that the paper tells apart.
  struct Forms {
    OctreeNodes uncompressed;        ///< every leaf that was pruned taken apart
    OctreeNodes pruned;              ///< the tree as it is
    OctreeNodes maximum_likelihood;  ///< every leaf just occupied or free, then pruned
  };

  virtual Forms forms() const = 0;
};

/// Null where the program was built without OctoMap.
std::unique_ptr<OctomapMap> make_octomap(double resolution);

/// "1.9.7", or nothing where the program was built without OctoMap.
std::string octomap_version();

}  // namespace rmap::evaluation
