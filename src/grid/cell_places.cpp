#include "grid/cell_places.hpp"

namespace rmap {

std::uint32_t CellPlaces::added(const Cell& cell) {
  const std::uint32_t place = size_++;
  slots_[slot_of(cell)] = {cell, size_};
  if (2 * std::size_t{size_} > slots_.size()) {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.number != 0) slots_[slot_of(slot.cell)] = slot;
    }
  }
  return place;
}

}  // namespace rmap
