#pragma once

#include <cstdint>
#include <functional>

#include <Eigen/Core>

namespace rmap {

/// Index (i, j, k) of a cell: it covers [i, i+1) x [j, j+1) x [k, k+1) times the resolution.
using Cell = Eigen::Vector3i;

/// Cell indices lie in [kMinCellIndex, kMaxCellIndex] on each axis: at 0.1 m, 107,374 km each way.
inline constexpr std::int32_t kMinCellIndex = -(1 << 30);
inline constexpr std::int32_t kMaxCellIndex = (1 << 30) - 1;

/// Whether every index of `cell` is within the limits.
inline bool within_limits(const Cell& cell) {
  return cell.minCoeff() >= kMinCellIndex && cell.maxCoeff() <= kMaxCellIndex;
}

/// A box of whole cells, half open: min is inside, max is the first cell outside on each axis.
/// Empty when max <= min on any axis.
struct CellBox {
  Cell min = Cell::Zero();
  Cell max = Cell::Zero();

  bool empty() const { return (max.array() <= min.array()).any(); }
  bool contains(const Cell& cell) const {
    return (cell.array() >= min.array()).all() && (cell.array() < max.array()).all();
  }
  /// Whether `other` lies in this box as a whole; an empty `other` lies nowhere.
  bool contains(const CellBox& other) const {
    return !other.empty() && (other.min.array() >= min.array()).all() &&
           (other.max.array() <= max.array()).all();
  }
  /// Whether the two boxes share a cell.
  bool overlaps(const CellBox& other) const { return !intersection(*this, other).empty(); }
  /// Edge lengths in cells; 64 bits, since a box across all limits has edges of 2^31.
  Eigen::Matrix<std::int64_t, 3, 1> extent() const {
    return max.cast<std::int64_t>() - min.cast<std::int64_t>();
  }
  /// Number of cells, 0 when empty. Exact below 2^53, else rounded once.
  double volume() const;

  /// The cells that both boxes share; may be empty.
  friend CellBox intersection(const CellBox& a, const CellBox& b) {
    return {.min = a.min.cwiseMax(b.min), .max = a.max.cwiseMin(b.max)};
  }
  /// The smallest box that holds both, neither being empty.
  friend CellBox united(const CellBox& a, const CellBox& b) {
    return {.min = a.min.cwiseMin(b.min), .max = a.max.cwiseMax(b.max)};
  }
  friend bool operator==(const CellBox& a, const CellBox& b) {
    return a.min == b.min && a.max == b.max;
  }
};

/// The box of the one cell.
inline CellBox box_of(const Cell& cell) { return {.min = cell, .max = cell + Cell::Ones()}; }

/// Every cell within the limits.
inline CellBox all_cells() {
  return {.min = Cell::Constant(kMinCellIndex), .max = Cell::Constant(kMaxCellIndex + 1)};
}

/// Order of the cells along the Morton (Z) curve, x the fastest axis: the order
/// of files and of sorted iteration. Total on all cells within the limits.
inline bool morton_less(const Cell& a, const Cell& b) {
  // The axis with the highest differing bit decides; of equal ones the slower axis.
  int axis = 2;
  std::uint32_t highest = static_cast<std::uint32_t>(a.z() ^ b.z());
  for (const int other : {1, 0}) {
    const auto difference = static_cast<std::uint32_t>(a[other] ^ b[other]);
    if (highest < difference && highest < (highest ^ difference)) {
      axis = other;
      highest = difference;
    }
  }
  return a[axis] < b[axis];
}

/// For hashed containers of cells.
struct CellHash {
  std::size_t operator()(const Cell& cell) const {
    std::uint64_t hash = static_cast<std::uint32_t>(cell.x());
    hash = hash * 0x9E3779B97F4A7C15u + static_cast<std::uint32_t>(cell.y());
    hash = hash * 0x9E3779B97F4A7C15u + static_cast<std::uint32_t>(cell.z());
    return static_cast<std::size_t>(hash ^ (hash >> 29));
  }
};

}  // namespace rmap
