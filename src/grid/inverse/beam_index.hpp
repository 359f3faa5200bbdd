#pragma once

#include "grid/inverse/cube_map.hpp"
#include "grid/inverse/depth_pyramid.hpp"
#include "grid/inverse/scratch.hpp"
#include "grid/point_tile.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <rmap/box.hpp>
#include <rmap/cell.hpp>

namespace rmap {

/// What casting reads of a BeamIndex: the beams sorted by bin, as columns.
struct IndexedBeams {
  Vector3d origin;  ///< of all beams, cell units
  Cell origin_cell;
  int bins;  ///< along an edge of a face
  /// 1 / direction in cell units, by axis; BeamIndex::kInfiniteInverse for 1 / 0.
  /// Whole vectors may be read from any beam on.
  std::array<const float*, 3> inverse;
  /// Number of each beam in its scan.
  const std::uint32_t* number;
  /// Bin u of row r holds the beams from borders[row_borders[r] + u] to, with it excluded,
  /// borders[row_borders[r] + u + 1].
  const std::int32_t* borders;
  const std::int32_t* row_borders;
  /// The largest depth of the beams in bin u of row r at row_borders[r] + u; 0 without beams.
  const float* depth;
};

/// The beams of a scan from one origin, sorted by direction, to find those that
/// can cross a box of cells: the heart of inverse beam casting.
class BeamIndex {
 public:
  /// Stands for 1 / 0: any plane that is not the origin's own is met beyond the end.
  static constexpr float kInfiniteInverse = 1e30F;

  /// For beams from `origin` (cell units) at up to `capacity` places, put in by
  /// `parts` threads, at least 1. `numbers` has the number of each place's beam in the
  /// scan, unless they are the same; it must outlive the index.
  BeamIndex(const Vector3d& origin, std::span<const std::uint32_t> numbers, std::size_t capacity,
            std::size_t parts);

  /// Takes the beams of a tile, for places `first` (a multiple of the tile's size)
  /// on. Different parts may be used beside one another; the places of a part must
  /// follow one another.
  void add(const PointTile& tile, std::size_t first, std::size_t part);
  /// Sorts what was added. No more may be added.
  void sort(int threads);

  /// Whether a beam without direction was cut: it crosses the cell of the origin alone,
  /// and is none of those that are sorted.
  bool has_cut_at_origin() const { return has_cut_at_origin_; }
  /// False only when no beam that has a direction crosses `box`.
  bool may_reach(const CellBox& box) const;
  const IndexedBeams& beams() const { return sorted_; }

 private:
  // What one thread knows of the bins that it filled: rows are cleared when they get
  // their first beam, since most never do.
  struct Part {
    std::size_t first = 0;  ///< places
    std::size_t last = 0;
    bool has_cut_at_origin = false;
    std::vector<std::uint8_t> row_used;
    std::int32_t* count = nullptr;  ///< beams of bin u at border(row) + u + 1; later places
    float* depth = nullptr;         ///< largest, of bin u at border(row) + u
  };

  void clear_row(Part& part, std::size_t row) const;
  std::size_t rows() const { return std::size_t{cube_map::kFaces} << bin_bits_; }
  std::size_t bins() const { return std::size_t{1} << bin_bits_; }
  std::size_t border(std::size_t row) const { return row * (bins() + 1); }

  Vector3d origin_;
  std::span<const std::uint32_t> numbers_;
  int bin_bits_;  ///< binary logarithm of the bins along an edge of a face
  Scratch scratch_;
  std::vector<Part> parts_;
  bool has_cut_at_origin_ = false;

  // As added, by place.
  std::uint32_t* bin_ = nullptr;
  std::array<float*, 3> inverse_{};

  // Sorted.
  std::uint32_t* sorted_number_ = nullptr;
  std::array<float*, 3> sorted_inverse_{};
  std::vector<std::int32_t> row_borders_;
  DepthPyramid depth_;
  IndexedBeams sorted_;
};

}  // namespace rmap
