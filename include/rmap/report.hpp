#pragma once

#include <cstddef>
#include <cstdint>

namespace rmap {

/// Points (and directions without return) of a scan that had no effect, by reason.
struct SkippedPoints {
  std::uint64_t not_finite = 0;
  std::uint64_t too_near = 0;       ///< nearer than min_range
  std::uint64_t beyond_limits = 0;  ///< the end is beyond the limits of cell indices
  std::uint64_t no_range = 0;  ///< no return, and neither max_range nor a sensor range is finite

  std::uint64_t total() const { return not_finite + too_near + beyond_limits + no_range; }
  SkippedPoints& operator+=(const SkippedPoints& other);
  friend bool operator==(const SkippedPoints&, const SkippedPoints&) = default;
};

/// What an insertion did. Sums over scans by +=.
struct InsertReport {
  std::uint64_t points = 0;    ///< points and directions without return that came in
  std::uint64_t inserted = 0;  ///< points that have an end cell
  std::uint64_t cut = 0;       ///< beams cut at max_range or without return: they only clear
  SkippedPoints skipped = {};
  std::uint64_t end_cells = 0;  ///< different cells in which a beam ended
  std::uint64_t new_cells = 0;  ///< end cells that did not exist before
  std::uint64_t hits = 0;       ///< cells whose value a hit changed, new ones too
  std::uint64_t misses = 0;     ///< cells whose value a miss changed

  InsertReport& operator+=(const InsertReport& other);
  friend bool operator==(const InsertReport&, const InsertReport&) = default;
};

/// What a preparation did.
struct PrepareReport {
  std::uint64_t points = 0;
  SkippedPoints skipped = {};
  std::uint64_t end_cells = 0;
  std::uint64_t new_cells = 0;

  PrepareReport& operator+=(const PrepareReport& other);
  friend bool operator==(const PrepareReport&, const PrepareReport&) = default;
};

/// Bytes that a grid has taken from the heap, by part.
struct BytesInUse {
  std::size_t nodes = 0;    ///< the R-tree
  std::size_t blocks = 0;   ///< bookkeeping of leaf branches
  std::size_t values = 0;   ///< log-odds, and in blocks which cells they belong to
  std::size_t records = 0;  ///< scan poses, journal of changes

  std::size_t total() const { return nodes + blocks + values + records; }
};

}  // namespace rmap
