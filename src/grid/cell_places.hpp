#pragma once

#include <cstdint>
#include <vector>

#include <rmap/cell.hpp>

namespace rmap {

/// Numbers cells from 0 on, in the order in which they are first met: an index for
/// what is gathered by cell in a vector beside it.
class CellPlaces {
 public:
  /// Place of `cell`, which becomes the next one when it is new.
  std::uint32_t add(const Cell& cell) {
    const std::uint32_t number = slots_[slot_of(cell)].number;
    return number == 0 ? added(cell) : number - 1;
  }
  /// Place of a cell that was added.
  std::uint32_t at(const Cell& cell) const { return slots_[slot_of(cell)].number - 1; }

 private:
  static constexpr std::size_t kFirstSlots = 1024;

  struct Slot {
    Cell cell = Cell::Zero();
    std::uint32_t number = 0;  ///< 1 + place, 0 when the slot is free
  };

  static std::size_t hash_of(const Cell& cell) {
    const auto index = [&](int axis) { return static_cast<std::uint32_t>(cell[axis]); };
    const std::uint32_t hash =
        (index(0) * 0x9E3779B1U) ^ (index(1) * 0x85EBCA77U) ^ (index(2) * 0xC2B2AE3DU);
    return hash ^ (hash >> 15);
  }
  // The slot that holds `cell`, or the free one where it belongs.
  std::size_t slot_of(const Cell& cell) const {
    std::size_t slot = hash_of(cell) & (slots_.size() - 1);
    while (slots_[slot].number != 0 && slots_[slot].cell != cell) {
      slot = (slot + 1) & (slots_.size() - 1);
    }
    return slot;
  }
  std::uint32_t added(const Cell& cell);

  std::vector<Slot> slots_ = std::vector<Slot>(kFirstSlots);  ///< open addressing; a power of two
  std::uint32_t size_ = 0;
};

}  // namespace rmap
