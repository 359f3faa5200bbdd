#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// When a leaf last changed: a revision counted from the log's base, in 32 bits.
using Stamp = std::uint32_t;

/// A list of (cell, revision) that remembers only its last entries.
class BoundedLog {
 public:
  explicit BoundedLog(std::size_t capacity) : capacity_(capacity) {}

  void add(const Cell& cell, std::uint64_t revision);
  /// Forgets everything up to `revision` and from now on keeps `capacity` entries.
  void restart(std::size_t capacity, std::uint64_t revision);
  std::size_t capacity() const { return capacity_; }

  /// Whether every entry after `revision` is still there.
  bool reaches_back_to(std::uint64_t revision) const { return revision >= horizon_; }
  /// The cells noted after `revision`, each once, in Morton order.
  std::vector<Cell> since(std::uint64_t revision) const;

  std::size_t bytes_in_use() const { return entries_.capacity() * sizeof(Entry); }

 private:
  struct Entry {
    std::uint64_t revision;
    Cell cell;
  };

  std::size_t capacity_;
  std::vector<Entry> entries_;  ///< a ring once it is full
  std::size_t oldest_ = 0;
  std::uint64_t horizon_ = 0;  ///< entries up to this revision may be gone
};

/// A grid's memory of its own changes: the revision, the blocks that lost
/// cells, and, when asked for, the cells that flipped.
class ChangeLog {
 public:
  std::uint64_t revision() const { return revision_; }
  /// Stamp of the running mutation.
  Stamp stamp() const { return static_cast<Stamp>(revision_ - base_); }
  /// Revision of a stamp.
  std::uint64_t revision_of(Stamp stamp) const { return base_ + stamp; }

  /// Starts a mutation. Returns false when 32 bits no longer hold its stamp:
  /// then all older stamps must be set to 0, and older changes are forgotten.
  [[nodiscard]] bool begin();
  /// Starts as if `revision` mutations had been made.
  void start_at(std::uint64_t revision) { revision_ = revision; }

  void lost_cells(const Cell& block) { erased_.add(block, revision_); }
  void flipped(const Cell& cell) {
    if (tracks_flips()) flips_.add(cell, revision_);
  }
  bool tracks_flips() const { return flips_.capacity() > 0; }
  void track_flips(std::size_t cells) { flips_.restart(cells, revision_); }

  /// Whether stamps and erased blocks tell all that changed after `revision`.
  bool knows_blocks_since(std::uint64_t revision) const {
    return revision >= base_ && erased_.reaches_back_to(revision);
  }
  bool knows_flips_since(std::uint64_t revision) const {
    return tracks_flips() && flips_.reaches_back_to(revision);
  }
  std::vector<Cell> blocks_with_losses_since(std::uint64_t revision) const {
    return erased_.since(revision);
  }
  std::vector<Cell> flipped_since(std::uint64_t revision) const { return flips_.since(revision); }

  std::size_t bytes_in_use() const { return erased_.bytes_in_use() + flips_.bytes_in_use(); }

 private:
  static constexpr std::size_t kErasedBlocks = 1 << 16;

  std::uint64_t revision_ = 0;
  std::uint64_t base_ = 0;
  BoundedLog erased_{kErasedBlocks};
  BoundedLog flips_{0};
};

}  // namespace rmap
