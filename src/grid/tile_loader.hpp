#pragma once

#include "grid/point_kernel.hpp"
#include "grid/point_tile.hpp"
#include "grid/scan_beams.hpp"

#include <span>

namespace rmap {

/// Fills tiles from the points of a scan, all of which start at one origin: by
/// SIMD what is plain, by ScanBeams the rest. The numbers are those of ScanBeams, bit for bit.
class TileLoader {
 public:
  /// `origin` in metres.
  TileLoader(const ScanBeams& beams, const Vector3d& origin, TileDetail detail);

  /// The points with numbers `first` to `first + count - 1`.
  void load(std::size_t first, std::size_t count, PointTile& tile);
  /// The points with these numbers.
  void load(std::span<const std::uint32_t> numbers, PointTile& tile);

  // Counts over all tiles loaded so far.
  std::uint64_t cut() const { return cut_; }
  const SkippedPoints& skipped() const { return skipped_; }

 private:
  void fill(PointTile& tile);

  const ScanBeams& beams_;
  PointKernelInput input_;
  std::uint64_t cut_ = 0;
  SkippedPoints skipped_;
};

}  // namespace rmap
