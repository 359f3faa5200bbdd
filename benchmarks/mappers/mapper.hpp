#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <rmap/cell.hpp>
#include <rmap/scan.hpp>

namespace rmap::bench {

/// A line from `origin` in `direction`; metres.
struct Ray {
  Vector3d origin;
  Vector3d direction;  ///< length 1
  double max_range;
};

/// What may be asked of a map.
class MapAnswers {
 public:
  virtual ~MapAnswers() = default;
  /// Goes over all occupied cells; their number.
  virtual std::size_t iterate() const = 0;
  virtual bool is_occupied(const Vector3d& point) const = 0;
  virtual std::optional<Cell> first_occupied(const Ray& ray) const = 0;
  virtual void save(const std::filesystem::path& file) const = 0;
  /// Reads a saved map; the number of its occupied cells.
  virtual std::size_t load(const std::filesystem::path& file) const = 0;
  virtual std::string extension() const = 0;
};

/// One way to make a map out of scans, and to ask it. Scans are in the map's frame,
/// with float32 points and origins, so that all mappers work on the same numbers.
class Mapper {
 public:
  virtual ~Mapper() = default;

  /// What is not timed: the scans in the mapper's own form. They live as long as it does.
  virtual void take(std::span<const Scan> scans) = 0;
  /// Passes over all scans before the first is inserted, where there are such.
  virtual void prepare() {}
  /// Inserts all scans.
  virtual void insert() = 0;

  /// Cells that exist: occupied, or free and kept.
  virtual std::size_t cell_count() const = 0;
  /// The occupied cells in Morton order.
  virtual std::vector<Cell> occupied() const = 0;

  /// Nothing for a mapper that is compared by its cells alone.
  virtual const MapAnswers* answers() const { return nullptr; }
};

/// A mapper to be measured.
struct Contender {
  std::string name;
  std::function<std::unique_ptr<Mapper>(double resolution)> make;
  /// Whether its map must be the reference's, but for beams that touch borders of cells.
  bool same_map = false;
  /// Whether its map is asked, saved and loaded too.
  bool asked = false;
};

std::vector<Contender> rmap_contenders();
std::vector<Contender> octomap_contenders();
/// None when the program was built without OpenVDB.
std::vector<Contender> openvdb_contenders();

/// All of them, the one that the others are compared with first.
std::vector<Contender> all_contenders();

}  // namespace rmap::bench
