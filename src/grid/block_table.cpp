#include "grid/block_table.hpp"

#include <rmap/error.hpp>

namespace rmap {

namespace {

constexpr int kMostBits = 31;  // a tag has one bit at least

}  // namespace

void BlockTable::enter(std::uint32_t hash, std::uint32_t number) {
  std::size_t slot = home_of(hash) * kBucket;
  while (slots_[slot] != kFree) slot = (slot + 1) & (slots_.size() - 1);
  slots_[slot] = tag_of(hash) | (number + 1);
}

bool BlockTable::take(std::size_t slot) {
  const std::size_t end = (slot / kBucket + 1) * kBucket;
  std::size_t last = slot;
  while (last + 1 < end && slots_[last + 1] != kFree) ++last;
  slots_[slot] = slots_[last];
  slots_[last] = kFree;
  return last + 1 == end;
}

std::vector<std::uint32_t> BlockTable::doubled() {
  if (bits_ == kMostBits) {
    throw Error(ErrorKind::limit, "the map is full: it holds at most 1610612736 blocks");
  }
  std::vector<std::uint32_t> slots(2 * slots_.size(), kFree);
  slots.swap(slots_);
  ++bits_;
  return slots;
}

}  // namespace rmap
