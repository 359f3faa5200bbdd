#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// Numbers cells from 0 on, in the order in which they are first met: an index for what is
/// gathered by cell in a vector beside it, which keeps the cells: cell_of(place) tells them.
class CellPlaces {
 public:
  /// With room for `expected` cells, or what memory in the nearer caches allows.
  explicit CellPlaces(std::size_t expected = 0)
      : bits_(std::clamp(static_cast<int>(std::bit_width(kSparseness * expected)), kFewestBits,
                         kMostBits)),
        slots_(std::size_t{1} << bits_) {}

  /// Also of the lowest cells of blocks: the high bits of a hash count.
  static std::uint32_t hash_of(const Cell& cell) {
    const auto index = [&](int axis) { return static_cast<std::uint32_t>(cell[axis]); };
    return index(0) * kFactors[0] + index(1) * kFactors[1] + index(2) * kFactors[2];
  }
  static constexpr std::uint32_t kFactors[3] = {0x9E3779B1U, 0x85EBCA77U, 0xC2B2AE3DU};

  /// Place of `cell`, which becomes the next one when it is new.
  template <class CellOf>
  std::uint32_t add(const Cell& cell, std::uint32_t hash, const CellOf& cell_of) {
    const std::uint32_t number = slots_[slot_of(cell, hash, cell_of)].number;
    return number == 0 ? added(hash) : number - 1;
  }
  /// Place of `cell`, if it has one.
  template <class CellOf>
  std::optional<std::uint32_t> find(const Cell& cell, const CellOf& cell_of) const {
    const std::uint32_t number = slots_[slot_of(cell, hash_of(cell), cell_of)].number;
    if (number == 0) return std::nullopt;
    return number - 1;
  }

 private:
  static constexpr int kFewestBits = 10;
  static constexpr int kMostBits = 15;
  // Slots for each cell, at the least: a probe that meets another cell costs more than memory.
  static constexpr std::size_t kSparseness = 8;

  struct Slot {
    std::uint32_t hash = 0;
    std::uint32_t number = 0;  ///< 1 + place, 0 when the slot is free
  };

  std::size_t first_slot(std::uint32_t hash) const { return hash >> (32 - bits_); }
  std::size_t next_slot(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }
  // The slot that holds `cell`, or the free one where it belongs.
  template <class CellOf>
  std::size_t slot_of(const Cell& cell, std::uint32_t hash, const CellOf& cell_of) const {
    std::size_t slot = first_slot(hash);
    while (slots_[slot].number != 0 &&
           (slots_[slot].hash != hash || cell_of(slots_[slot].number - 1) != cell)) {
      slot = next_slot(slot);
    }
    return slot;
  }
  void enter(const Slot& entry);
  std::uint32_t added(std::uint32_t hash);

  int bits_;                 ///< binary logarithm of the number of slots
  std::vector<Slot> slots_;  ///< open addressing
  std::uint32_t size_ = 0;
};

}  // namespace rmap
