#pragma once

#include <array>
#include <bitset>
#include <cstdint>

#include <rmap/rtree/record_pool.hpp>
#include <rmap/value.hpp>

namespace rmap {

/// Memory for runs of 1 to kMaxCount values. A run takes whole granules of 4 values;
/// freed runs are used again, the best fitting first, and split where they are
/// longer than needed: so growing blocks leave little behind. Pages are never
/// moved.
class ValuePool {
 public:
  using Handle = std::uint32_t;

  /// The longest run.
  static constexpr std::uint32_t kMaxCount = 548;

  ValuePool();

  /// A run of `count` values, 1 to kMaxCount, uninitialised.
  Handle allocate(std::uint32_t count);
  /// Gives back a run that was allocated with the same `count`.
  void release(Handle run, std::uint32_t count);

  Value* at(Handle run) { return pages_.record(run / kPageGranules) + offset(run); }
  const Value* at(Handle run) const { return pages_.record(run / kPageGranules) + offset(run); }

  /// Whether runs of the two lengths take the same memory.
  static bool same_size(std::uint32_t a, std::uint32_t b) { return granules(a) == granules(b); }

  std::size_t bytes_in_use() const { return pages_.bytes_in_use(); }
  /// Values that lie in freed runs.
  std::size_t free_values() const { return free_granules_ * kGranule; }

 private:
  static constexpr std::uint32_t kGranule = 4;
  static constexpr std::uint32_t kPageGranules = 2048;
  static constexpr std::uint32_t kMaxGranules = kMaxCount / kGranule;
  static constexpr Handle kNone = UINT32_MAX;

  static std::uint32_t granules(std::uint32_t count) { return (count + kGranule - 1) / kGranule; }
  static std::size_t offset(Handle run) { return std::size_t{run % kPageGranules} * kGranule; }

  void push_free(Handle run, std::uint32_t length);
  Handle pop_free(std::uint32_t length);
  void add_page();

  RecordPool<Value> pages_;
  /// Freed runs by length in granules: lists linked through the runs themselves.
  std::array<Handle, kMaxGranules + 1> free_;
  std::bitset<kMaxGranules + 1> has_free_;
  std::size_t free_granules_ = 0;
  /// What is left of the last page.
  Handle tail_ = 0;
  std::uint32_t tail_length_ = 0;
};

}  // namespace rmap
