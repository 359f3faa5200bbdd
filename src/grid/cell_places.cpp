#include "grid/cell_places.hpp"

namespace rmap {

void CellPlaces::enter(const Slot& entry) {
  std::size_t slot = first_slot(entry.hash);
  while (slots_[slot].number != 0) slot = next_slot(slot);
  slots_[slot] = entry;
}

std::uint32_t CellPlaces::added(std::uint32_t hash) {
  const std::uint32_t place = size_++;
  enter({hash, size_});
  if (kSparseness * size_ > slots_.size()) {
    std::vector<Slot> old(2 * slots_.size());
    old.swap(slots_);
    ++bits_;
    for (const Slot& slot : old) {
      if (slot.number != 0) enter(slot);
    }
  }
  return place;
}

}  // namespace rmap
