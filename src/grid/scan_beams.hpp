#pragma once

#include <optional>

#include <rmap/beam.hpp>
#include <rmap/lattice.hpp>
#include <rmap/options.hpp>
#include <rmap/report.hpp>
#include <rmap/scan.hpp>

namespace rmap {

/// What becomes of a point of a scan, or of a direction without return.
struct SortedPoint {
  enum class Fate : std::uint8_t {
    ends,     ///< a beam that ends in a cell
    cut,      ///< a beam that only clears
    skipped,  ///< no beam
  };
  Fate fate;
  std::uint64_t SkippedPoints::*reason = nullptr;  ///< why it is skipped
  Vector3d origin = Vector3d::Zero();              ///< of the beam, cell units
  Vector3d end = Vector3d::Zero();                 ///< of the beam, cell units
};

/// The beams of a scan by the letter of the definition, one at a time: number i
/// belongs to point i, and behind the points come the directions without return.
/// Holds references to what it is made of.
class ScanBeams {
 public:
  /// Throws what Grid::insert throws about the scan as a whole.
  ScanBeams(const Scan& scan, const Lattice& lattice, const Options& options);

  const Scan& scan() const { return scan_; }
  const Lattice& lattice() const { return lattice_; }
  const Options& options() const { return options_; }

  std::size_t point_count() const { return scan_.points.size(); }
  std::size_t size() const { return scan_.points.size() + scan_.no_returns.size(); }
  /// Where beam i starts, metres.
  const Vector3d& origin(std::size_t i) const {
    return i < scan_.origins.size() ? scan_.origins[i] : center_;
  }

  /// Sorts out point i, in this order: not finite; nearer than min_range; beyond
  /// max_range (cut there); beyond the limits of cell indices. Throws Error(limit)
  /// about a bad point when the options say so.
  SortedPoint sorted(std::size_t i) const;
  /// Beam i; nothing when the point is skipped.
  std::optional<Beam> beam(std::size_t i) const;

 private:
  SortedPoint sorted_point(const Vector3f& point, const Vector3d& origin) const;
  SortedPoint sorted_direction(const Vector3f& direction, const Vector3d& origin) const;
  SortedPoint cut(const Vector3f& point, const Vector3d& origin, const Vector3d& along,
                  double length, double range) const;
  SortedPoint skipped(std::uint64_t SkippedPoints::*reason, const Vector3f& point,
                      const char* what) const;

  const Scan& scan_;
  const Lattice& lattice_;
  const Options& options_;
  Vector3d center_;
};

}  // namespace rmap
